// References: sums in closed form; percentiles by counting, as their definition says.
#include "engine/record/summary.h"

#include <gtest/gtest.h>

#include <limits>
#include <nlohmann/json.hpp>
#include <random>

#include "haptics/safety/faults.h"
#include "synthetic_run.h"

namespace fulcrum::record {
namespace {

// The smallest of the times that at least `share` of them do not exceed.
double percentile_by_counting(const std::vector<std::int64_t>& times, int per_mille) {
  std::int64_t best = std::numeric_limits<std::int64_t>::max();
  for (const std::int64_t candidate : times) {
    const auto within = std::count_if(times.begin(), times.end(), [&](auto t) { return t <= candidate; });
    if (within * 1000 >= per_mille * std::ssize(times)) best = std::min(best, candidate);
  }
  return static_cast<double>(best) / 1000;
}

TEST(Percentiles, AreWhatCountingGives) {
  std::mt19937_64 random(1);
  for (const std::size_t count : {1u, 2u, 3u, 99u, 100u, 101u, 999u, 1000u, 1001u, 1500u}) {
    std::vector<std::int64_t> times(count);
    for (std::int64_t& time : times) time = static_cast<std::int64_t>(random() % 500);  // with ties
    std::vector<std::int64_t> sorted = times;
    const TickCpu cpu = tick_cpu_percentiles(sorted);
    EXPECT_EQ(cpu.p50, percentile_by_counting(times, 500)) << count;
    EXPECT_EQ(cpu.p99, percentile_by_counting(times, 990)) << count;
    EXPECT_EQ(cpu.p999, percentile_by_counting(times, 999)) << count;
    EXPECT_EQ(cpu.max, percentile_by_counting(times, 1000)) << count;
  }
}

TEST(Summary, TellsWhatWasHeardWhereSomebodyListened) {
  Summary summary;
  EXPECT_FALSE(nlohmann::json::parse(summary_json(summary)).contains("heard"));
  summary.heard = HeardScene{.device = "A card", .blows = 1};
  EXPECT_TRUE(nlohmann::json::parse(summary_json(summary))["heard"]["latency_ms"].is_null());
  EXPECT_EQ(heard_text(*summary.heard), "1 blow on A card");
  summary.heard = HeardScene{"A card", 12, 2, 3, true, SoundLatency{17.4, 20.6}};
  const auto heard = nlohmann::json::parse(summary_json(summary))["heard"];
  EXPECT_EQ(heard["device"], "A card");
  EXPECT_EQ(heard["blows"], 12);
  EXPECT_EQ(heard["dropped"], 2);
  EXPECT_EQ(heard["late"], 3);
  EXPECT_EQ(heard["unplugged"], true);
  EXPECT_EQ(heard["latency_ms"]["mean"], 17.4);
  EXPECT_EQ(heard["latency_ms"]["max"], 20.6);
  EXPECT_EQ(
      heard_text(*summary.heard),
      "12 blows on A card: 17 ms from a blow to the loudspeaker, at most 21 ms; 2 made room for stronger "
      "ones; then the device was unplugged; 3 came too late to be heard");
}

TEST(Summary, TellsHowOldPicturesWereWhereSomebodySawThem) {
  Summary summary;
  EXPECT_FALSE(nlohmann::json::parse(summary_json(summary)).contains("hand_to_pixel_ms"));
  HandToPixelMeter meter;
  meter.add({0, 1'000'000, 3'000'000, 23'000'000, 24'000'000});
  summary.hand_to_pixel = meter.figures();
  const auto told = nlohmann::json::parse(summary_json(summary))["hand_to_pixel_ms"];
  EXPECT_EQ(told["frames"], 1);
  const std::pair<const char*, double> stages[] = {
      {"tick", 1}, {"wait", 2}, {"draw", 20}, {"show", 1}, {"whole", 24}};
  for (const auto& [name, ms] : stages)
    for (const char* figure : {"p50", "p99", "max"}) EXPECT_NEAR(told[name][figure], ms, 1e-9) << name;
}

TEST(Summary, TellsHowWellADeviceWasSeenWhereItIsFelt) {
  Summary summary;
  EXPECT_FALSE(nlohmann::json::parse(summary_json(summary)).contains("colocation"));
  summary.colocation = Colocated{"stage", 0.002, {0.001, 0.002, 0.003}};
  const auto told = nlohmann::json::parse(summary_json(summary))["colocation"];
  EXPECT_EQ(told["space"], "stage");
  EXPECT_EQ(told["residual_m"], 0.002);
  EXPECT_EQ(told["residuals_m"], (std::vector<double>{0.001, 0.002, 0.003}));
}

TEST(RunTotals, IntegratesAndPeaks) {
  RunTotals totals(0.002);
  for (int tick = 0; tick < 500; ++tick) {
    TickRecord record;
    record.tick = tick;
    record.coupling_F_T_W = {Vec3(3, 0, 4), Vec3(0, -0.5, 0)};
    record.contact_F_T_W = {Vec3(0, tick < 250 ? 2 : 0, 0), Vec3(tick == 50 ? 0.2 : 0.1, 0, 0)};
    record.device_F_H_D.force = Vec3(0, tick == 100 ? -6 : 1, 0);
    record.device_F_H_D.torque = Vec3(tick == 200 ? 0.3 : 0, 0, tick == 200 ? 0.4 : 0);
    totals.add(record);
  }
  EXPECT_EQ(totals.ticks(), 500);
  EXPECT_NEAR(totals.torque_error_Nms(), 0.5, 1e-12);
  EXPECT_NEAR(totals.force_error_Ns(), 1.0, 1e-12) << "of contact: half the time 2 N";
  EXPECT_DOUBLE_EQ(totals.peak_force_N(), 2);
  EXPECT_DOUBLE_EQ(totals.peak_torque_Nm(), 0.2);
  EXPECT_NEAR(totals.force_error_rendered_Ns(), (499 * 1 + 6) * 0.002, 1e-12);
  EXPECT_DOUBLE_EQ(totals.peak_force_rendered_N(), 6);
  EXPECT_DOUBLE_EQ(totals.peak_torque_rendered_Nm(), 0.5);
}

TEST(RunTotals, RestWhileTheForceIsStopped) {
  RunTotals totals(0.001);
  TickRecord record;
  record.coupling_F_T_W.torque = Vec3(0, 0.5, 0);
  record.contact_F_T_W.force = Vec3(0, 2, 0);
  totals.add(record);
  record.stopped = true;
  record.contact_F_T_W.force = Vec3(0, 3, 0);
  totals.add(record);
  EXPECT_EQ(totals.ticks(), 2);
  EXPECT_DOUBLE_EQ(totals.torque_error_Nms(), 0.0005);
  EXPECT_DOUBLE_EQ(totals.force_error_Ns(), 0.002);
  EXPECT_EQ(totals.peak_force_N(), 2);
}

// A tool that hangs in the air by its coupling, on a device without motors, touches nothing.
TEST(RunTotals, WeightIsNoForceOfContact) {
  RunTotals totals(0.001);
  TickRecord record;
  record.coupling_F_T_W.force = Vec3(0, 1.53, 0);
  totals.add(record);
  EXPECT_EQ(totals.force_error_Ns(), 0);
  EXPECT_EQ(totals.peak_force_N(), 0);
}

TEST(RunTotals, ANumberThatIsNoneSpoilsNothing) {
  RunTotals totals(0.001);
  TickRecord good, bad;
  good.contact_F_T_W.force = Vec3(1, 0, 0);
  good.device_F_H_D.force = Vec3(2, 0, 0);
  bad.contact_F_T_W.force.x() = std::numeric_limits<double>::quiet_NaN();
  bad.device_F_H_D.force.x() = std::numeric_limits<double>::quiet_NaN();
  totals.add(good);
  totals.add(bad);
  totals.add(good);
  EXPECT_DOUBLE_EQ(totals.force_error_Ns(), 0.002);
  EXPECT_EQ(totals.peak_force_N(), 1);
  EXPECT_EQ(totals.peak_force_rendered_N(), 2);
}

TEST(RunTotals, TellsFaultsFromLimits) {
  RunTotals totals(0.001);
  for (int tick = 10; tick < 20; ++tick) {
    TickRecord record;
    record.tick = tick;
    record.faults = (tick >= 15 ? std::uint32_t{kDeviceLost} : 0u) | (tick % 2 == 0 ? kForceClamped : 0u);
    totals.add(record);
  }
  ASSERT_EQ(totals.faults().size(), 1u);
  EXPECT_EQ(totals.faults()[0].name, "device_lost");
  EXPECT_EQ(totals.faults()[0].first_tick, 15);
  EXPECT_EQ(totals.faults()[0].ticks, 5);
  EXPECT_FALSE(totals.faults()[0].sentence.empty());
  ASSERT_EQ(totals.limits().size(), 1u);
  EXPECT_EQ(totals.limits()[0].name, "force_clamped");
  EXPECT_EQ(totals.limits()[0].ticks, 5);
}

TEST(Summary, HasTheKeysOfTheContractInItsOrder) {
  const nlohmann::ordered_json document = nlohmann::ordered_json::parse(summary_json(Summary()));
  std::string keys;
  for (const auto& [key, value] : document.items()) keys += key + ' ';
  EXPECT_EQ(keys,
            "version scenario device hand seed ticks tick_s completed checkpoints completion_time_s "
            "torque_error_Nms "
            "force_error_Ns force_error_rendered_Ns peak_force_N peak_force_rendered_N peak_torque_Nm "
            "peak_torque_rendered_Nm max_penetration_m max_penetration_within_m max_penetration_at_s "
            "max_penetration_part tick_cpu_us late_ticks lost_ticks faults "
            "limits built left_out trace_sha256 ");
  for (const char* unknown : {"completion_time_s", "max_penetration_m", "tick_cpu_us", "trace_sha256"})
    EXPECT_TRUE(document[unknown].is_null()) << unknown;
  EXPECT_TRUE(document["checkpoints"].is_array());
  EXPECT_TRUE(document["faults"].is_array());
}

TEST(Summary, SaysWhatIsKnown) {
  RunTotals totals(0.001);
  TickRecord record;
  record.tick = 3;
  record.faults = kNotFinite | kSlewLimited;
  totals.add(record);
  Summary summary;
  summary.take(totals);
  summary.scenario = "piping";
  summary.seed = -9007199254740993;
  summary.checkpoints = {{"bend", 1.5}, {"end", std::nullopt}};
  summary.max_penetration_m = 0.001;
  summary.tick_cpu_us = TickCpu{1, 2, 3, 4.5};
  summary.trace_sha256 = std::string(64, '0');
  summary.left_out = {"picture: no Vulkan device"};
  const nlohmann::json document = nlohmann::json::parse(summary_json(summary));
  EXPECT_EQ(document["seed"], -9007199254740993);
  EXPECT_FALSE(document.contains("guided"));
  summary.guided = true;
  EXPECT_EQ(nlohmann::json::parse(summary_json(summary))["guided"], true);
  EXPECT_EQ(document["checkpoints"][0], (nlohmann::json{{"name", "bend"}, {"reached_s", 1.5}}));
  EXPECT_TRUE(document["checkpoints"][1]["reached_s"].is_null());
  EXPECT_EQ(document["tick_cpu_us"]["p999"], 3);
  EXPECT_EQ(document["faults"][0]["name"], "not_finite");
  EXPECT_EQ(document["faults"][0]["first_tick"], 3);
  EXPECT_EQ(document["limits"], nlohmann::json::parse(R"([{"name": "slew_limited", "ticks": 1}])"));
}

TEST(Summary, HardTouchesAreThereWhereTheTaskCountsThem) {
  Summary summary;
  EXPECT_FALSE(nlohmann::json::parse(summary_json(summary)).contains("hard_touches"));
  summary.hard_touches = {3, 0.25};
  const nlohmann::json document = nlohmann::json::parse(summary_json(summary));
  EXPECT_EQ(document["hard_touches"], 3);
  EXPECT_EQ(document["hard_touch_s"], 0.25);
}

TEST(Summary, IsANewFile) {
  const TemporaryFolder folder;
  ASSERT_TRUE(write_summary(folder.path(), Summary()));
  EXPECT_EQ(contents(folder / "summary.json"), summary_json(Summary()));
  EXPECT_FALSE(write_summary(folder.path(), Summary()));
}

}  // namespace
}  // namespace fulcrum::record
