// What a device test hears of samples and tells of channels, and its report.

#include <nlohmann/json.hpp>

#include "engine/app/device_test/report.h"
#include "tests/app/tested_devices.h"

namespace fulcrum::test {
namespace {

// x jumps between two places, 0.4 mm apart, and samples come every 4 ms, 1 to 4 ms old.
TEST(DeviceTestSamples, RateAgeAndNoiseAreTheDevices) {
  Played device(pad());
  device.on_read = [](Played& d) {
    const int since = d.ticks % 4;
    d.sample.age = 1e-3 * (1 + since);
    if (since == 0) d.place.x() = d.ticks / 4 % 2 == 0 ? 2e-4 : -2e-4;
    d.sample.X_DH.p = d.place;
  };
  const dt::Findings findings = walk_alone(device);
  const dt::Part& samples = part(findings, "samples");
  EXPECT_NEAR(measure(samples, "rate"), 250, 1);
  EXPECT_EQ(samples.outcome, Outcome::good);
  EXPECT_GE(measure(samples, "age, median"), 2);
  EXPECT_LE(measure(samples, "age, median"), 3);
  EXPECT_EQ(measure(samples, "age, 99 %"), 4);
  const dt::Part& noise = part(findings, "noise at rest");
  EXPECT_NEAR(measure(noise, "rms x"), 200, 0.5);  // um
  EXPECT_EQ(measure(noise, "rms y"), 0);
  EXPECT_EQ(noise.outcome, Outcome::odd);
}

TEST(DeviceTestSamples, SlowerThanItsTableIsSaid) {
  Played device(pad());
  device.on_read = [](Played& d) { d.sample.age = 1e-3 * (1 + d.ticks % 8); };
  EXPECT_EQ(part(walk_alone(device), "samples").outcome, Outcome::odd);
}

TEST(DeviceTestSamples, ASilenceOfADeviceWithoutMotorsIsADropOut) {
  Played device(pad());
  device.on_read = [](Played& d) {
    d.sample.age = d.ticks >= 900 && d.ticks < 960 ? 1e-3 * (d.ticks - 899) : 0;
  };
  dt::TestBench bench = bench_of(device);
  dt::NobodyThere nobody;
  dt::walk(bench, nobody);
  EXPECT_FALSE(bench.stopped());
  EXPECT_EQ(bench.dropouts(), 1);
  EXPECT_NEAR(bench.largest_age(), 0.06, 1e-9);
}

TEST(DeviceTestSamples, EachChannelVibratesByItselfAtHalfItsStrength) {
  Played device(pad());
  dt::TestBench bench = bench_of(device);
  Scripted person;
  person.says = [](const std::string& question) {
    return question.find("Did it vibrate") != std::string::npos ? Answer::no : Answer::yes;
  };
  const dt::Findings findings = dt::walk(bench, person);
  EXPECT_EQ(part(findings, "vibration left").outcome, Outcome::bad);
  double most[2] = {0, 0};
  for (const DeviceCommand& command : device.told) {
    const auto& level = command.vibrotactile.level;
    EXPECT_TRUE(level[0] == 0 || level[1] == 0);
    most[0] = std::max(most[0], level[0]);
    most[1] = std::max(most[1], level[1]);
  }
  EXPECT_EQ(most[0], 10);
  EXPECT_EQ(most[1], 5);
  EXPECT_EQ(device.told.back().vibrotactile.level[1], 0);
  EXPECT_EQ(dt::signal_of_test(*device.desc().vibrotactile).largest, 10);
}

TEST(DeviceTestSamples, TheReportHasWhatWasFound) {
  Free device(arm());
  const dt::Findings findings = walk_alone(device);
  const std::string page = dt::page(findings, "Arm", {{"command", "fulcrum device-test arm"}}).html();
  for (const char* const word :
       {"Device test: Arm", "push up and down: good", "fulcrum device-test arm", "<svg"})
    EXPECT_NE(page.find(word), std::string::npos) << word;
  const std::string csv = dt::csv(findings).text();
  EXPECT_TRUE(csv.starts_with("part,outcome,measure,value,unit\n"));
  EXPECT_NE(csv.find("samples,good,rate,"), std::string::npos);
  const nlohmann::ordered_json json = dt::as_json(findings);
  EXPECT_EQ(json["outcome"], "good");
  EXPECT_EQ(json["parts"].size(), findings.parts.size());
}

}  // namespace
}  // namespace fulcrum::test
