// The expert's run as it is kept and shown beside a trainee's: read again to the bit, and nothing believed
// that no run can have come to.

#include "engine/app/run/expert.h"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/app/run/expert_file.h"

namespace fulcrum::app {
namespace {

constexpr double kLimit = 30;  // s
constexpr const char* kKey = "0123";

// Two of three checkpoints in 12 s.
ExpertRun example() {
  ExpertRun run;
  run.metrics.time = 12;
  run.metrics.checkpoints = 3;
  run.metrics.checkpoints_reached = 2;
  run.metrics.path = 0.7;
  run.metrics.smoothness = -2.5;
  run.metrics.contact_time = 3;
  run.metrics.force_mean = 0.5;
  run.metrics.force_95 = 1.1;
  run.metrics.force_peak = 1.2;
  run.reached = {4.0, 10.0, std::nullopt};
  for (int i = 0; i <= 12; ++i)
    run.way.push_back({static_cast<double>(i),
                       {Quat(Eigen::AngleAxisd(0.1 * i, Vec3::UnitY())), {0.01 * i, 1.0 / 3.0, -0.2}}});
  return run;
}

std::optional<ExpertRun> read(const std::string& text) {
  return read_expert(text, kKey, 3, kLimit);
}

// The example, changed as JSON.
std::optional<ExpertRun> read_changed(const std::function<void(nlohmann::json&)>& change) {
  nlohmann::json document = nlohmann::json::parse(expert_text(example(), kKey));
  change(document);
  return read(document.dump());
}

TEST(ExpertFile, IsReadAgainToTheBit) {
  const ExpertRun run = example();
  const std::optional<ExpertRun> again = read(expert_text(run, kKey));
  ASSERT_TRUE(again);
  EXPECT_EQ(named_values(again->metrics), named_values(run.metrics));
  EXPECT_EQ(again->reached, run.reached);
  ASSERT_EQ(again->way.size(), run.way.size());
  for (std::size_t i = 0; i < run.way.size(); ++i) {
    EXPECT_EQ(again->way[i].time, run.way[i].time);
    EXPECT_EQ(again->way[i].shown.p, run.way[i].shown.p);
    EXPECT_EQ(again->way[i].shown.q.coeffs(), run.way[i].shown.q.coeffs());
  }
}

TEST(ExpertFile, OfAnotherKeyVersionOrTaskIsNone) {
  const std::string text = expert_text(example(), kKey);
  EXPECT_FALSE(read_expert(text, "4567", 3, kLimit));
  EXPECT_FALSE(read_expert(text, kKey, 2, kLimit));
  EXPECT_FALSE(read_expert(text, kKey, 3, 11)) << "it took longer than the task may";
  EXPECT_FALSE(read_changed([](auto& d) { d["version"] = kExpertFileVersion + 1; }));
  EXPECT_FALSE(read_changed([](auto& d) { d.erase("version"); }));
  // As version 1 was: figures alone.
  EXPECT_FALSE(read_changed([](auto& d) { d = {{"key", d["key"]}, {"figures", d["figures"]}}; }));
}

TEST(ExpertFile, WithFiguresThatNoRunHasIsNone) {
  ASSERT_TRUE(read_changed([](auto&) {}));
  const auto figure = [](const char* name, const nlohmann::json& value) {
    return read_changed([&](auto& d) { d["figures"][name] = value; }).has_value();
  };
  ASSERT_TRUE(figure("path_m", 0.71));
  EXPECT_FALSE(figure("completed", 0.3));
  EXPECT_FALSE(figure("completed", 1)) << "with one of the checkpoints still to come";
  EXPECT_FALSE(figure("time_s", -5));
  EXPECT_FALSE(figure("time_s", 1e300));
  EXPECT_FALSE(figure("time_s", "12"));
  EXPECT_FALSE(figure("time_s", nullptr));
  EXPECT_FALSE(figure("checkpoints_reached", 4));
  EXPECT_FALSE(figure("checkpoints_reached", 1.5));
  EXPECT_FALSE(figure("checkpoints_reached", -1));
  EXPECT_FALSE(figure("contact_s", 13));
  EXPECT_FALSE(figure("force_mean_N", 1.3)) << "above its peak";
  EXPECT_FALSE(figure("path_m", -0.1));
  EXPECT_FALSE(figure("touches_on_the_way", 0.5));
  EXPECT_FALSE(figure("luck", 1));
  EXPECT_FALSE(read_changed([](auto& d) { d["figures"].erase("force_peak_N"); }));
}

TEST(ExpertFile, WithAWayThatNoToolWentIsNone) {
  const auto value = [](std::size_t frame, std::size_t at, double to) {
    return read_changed([&](auto& d) { d["way"][frame][at] = to; }).has_value();
  };
  ASSERT_TRUE(value(5, 1, 0.06));
  EXPECT_FALSE(value(0, 0, -1)) << "before the beginning";
  EXPECT_FALSE(value(5, 0, 3.5)) << "backwards";
  EXPECT_FALSE(value(12, 0, 12.5)) << "beyond the end";
  EXPECT_FALSE(value(5, 1, 1e9)) << "a million kilometres off";
  EXPECT_FALSE(value(5, 4, 0.1)) << "no turn";
  EXPECT_FALSE(read_changed([](auto& d) { d["way"][5].push_back(0); }));
  EXPECT_FALSE(read_changed([](auto& d) { d["way"][5] = 7; }));
  EXPECT_FALSE(read_changed([](auto& d) { d["way"] = nlohmann::json::array(); }));
  EXPECT_FALSE(read_changed([](auto& d) {
    const nlohmann::json frame = d["way"][0];
    for (std::size_t i = 0; i <= ToolFilm::kMost; ++i) {
      d["way"].push_back(frame);
      d["way"].back()[0] = 11 + 1e-4 * static_cast<double>(i + 1);
    }
  })) << "more than is ever kept";
  const auto reached = [](const nlohmann::json& times) {
    return read_changed([&](auto& d) { d["reached_s"] = times; }).has_value();
  };
  ASSERT_TRUE(reached({3.0, 10.0, nullptr}));
  EXPECT_FALSE(reached({10.0, 4.0, nullptr}));
  EXPECT_FALSE(reached({-1.0, 4.0, nullptr}));
  EXPECT_FALSE(reached({4.0, nullptr, 10.0}));
  EXPECT_FALSE(reached({4.0, 10.0, 11.0})) << "the figures say two";
  EXPECT_FALSE(reached({4.0, 10.0}));
  EXPECT_FALSE(reached({4.0, 10.0, "later"}));
}

TEST(ExpertFile, DamagedOrNestedWithoutEndIsNone) {
  const std::string text = expert_text(example(), kKey);
  for (std::size_t size = 0; size + 2 < text.size(); size += 7) EXPECT_FALSE(read(text.substr(0, size)));
  EXPECT_FALSE(read(std::string(1'000'000, '[')));
  EXPECT_FALSE(read(std::string(1'000'000, '[') + std::string(1'000'000, ']')));
  std::string object;
  for (int i = 0; i < 1'000'000; ++i) object += "{\"key\":";
  EXPECT_FALSE(read(object));
  std::string within = text;
  within.replace(within.find("\"way\":["), 7,
                 "\"way\":[" + std::string(200'000, '[') + std::string(200'000, ']') + ",");
  EXPECT_FALSE(read(within));
  std::string nan = text;
  nan.replace(nan.find("0.7"), 3, "NaN");
  EXPECT_FALSE(read(nan));
  std::string huge = text;
  huge.replace(huge.find("0.7"), 3, "1e999");
  EXPECT_FALSE(read(huge));
  EXPECT_FALSE(read(std::string("\0\xff\xfe", 3)));
}

// The expert's checkpoints at 4 and 10 s of 12; the trainee's at 8 s, and no other.
TEST(ExpertRun, IsShownAtTheSamePartOfTheTask) {
  const ExpertRun run = example();
  const std::vector<std::optional<double>> reached = {8.0, std::nullopt, std::nullopt};
  EXPECT_NEAR(same_part(run, reached, 0), 0, 1e-12);
  EXPECT_NEAR(same_part(run, reached, 4), 2, 1e-12) << "half of the first part";
  EXPECT_NEAR(same_part(run, reached, 8), 4, 1e-12);
  EXPECT_NEAR(same_part(run, reached, 11), 7, 1e-12) << "then at the expert's own pace";
  EXPECT_NEAR(same_part(run, reached, 25), 10, 1e-12) << "up to the checkpoint that was missed";
  // One that both finished; where the expert did not, its run's end stands for it.
  const std::vector<std::optional<double>> all = {8.0, 9.0, 19.0};
  EXPECT_NEAR(same_part(run, all, 8.5), 7, 1e-12);
  EXPECT_NEAR(same_part(run, all, 14), 11, 1e-12);
  EXPECT_NEAR(same_part(run, all, 19), 12, 1e-12);
  EXPECT_NEAR(same_part(run, all, 40), 12, 1e-12);
  EXPECT_NEAR(same_part(run, {}, 5), 5, 1e-12) << "without checkpoints, at the same second";
  // The second one was passed: from 4 s to 12 s of the expert while the trainee goes from 8 s to 18 s.
  const std::vector<std::optional<double>> passed = {8.0, std::nullopt, 18.0};
  EXPECT_NEAR(same_part(run, passed, 13), 8, 1e-12);
  const std::vector<std::optional<double>> other_order = {8.0, 3.0, 19.0};
  EXPECT_NEAR(same_part(run, other_order, 5), 5, 1e-12) << "at the same second";
  EXPECT_NEAR(same_part(run, other_order, 50), 12, 1e-12);
  // Two checkpoints in the same tick.
  const std::vector<std::optional<double>> at_once = {8.0, 8.0, std::nullopt};
  EXPECT_NEAR(same_part(run, at_once, 8), 10, 1e-12);
}

TEST(ExpertRun, MovesBetweenThePosesThatAreKept) {
  const ExpertRun run = example();
  const Pose at = tool_at(run, 3.25);
  EXPECT_NEAR(at.p.x(), 0.0325, 1e-12);
  EXPECT_NEAR(at.q.angularDistance(Quat(Eigen::AngleAxisd(0.325, Vec3::UnitY()))), 0, 1e-9);
  EXPECT_EQ(tool_at(run, -1).p, run.way.front().shown.p);
  EXPECT_EQ(tool_at(run, 99).p, run.way.back().shown.p);
}

// XDG_CACHE_HOME for as long as it lives: a folder of its own.
class OwnCache {
public:
  OwnCache() {
    if (const char* before = std::getenv(kName)) before_ = before;
    std::filesystem::remove_all(folder_);
    ::setenv(kName, folder_.c_str(), 1);
  }
  ~OwnCache() {
    std::filesystem::remove_all(folder_);
    if (before_)
      ::setenv(kName, before_->c_str(), 1);
    else
      ::unsetenv(kName);
  }
  OwnCache(const OwnCache&) = delete;
  OwnCache& operator=(const OwnCache&) = delete;

  std::filesystem::path only_file() const {
    std::filesystem::path found;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder_))
      if (entry.is_regular_file()) found = entry.path();
    return found;
  }

private:
  static constexpr const char* kName = "XDG_CACHE_HOME";
  std::filesystem::path folder_ = testing::TempDir() + "fulcrum-expert-cache";
  std::optional<std::string> before_;
};

std::string text_of(const std::filesystem::path& file) {
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(WatchExpert, KeepsWhatItSawAndMakesAnewWhatItCannotBelieve) {
  const std::optional<Prepared> stick = prepare("stick", std::vector<std::string>());
  ASSERT_TRUE(stick);
  const OwnCache cache;
  int watched = 0;
  const auto watch = [&] {
    watched = 0;
    return watch_expert(*stick, [&](double) { return ++watched > 0; });
  };
  const std::optional<ExpertRun> seen = watch();
  ASSERT_TRUE(seen);
  EXPECT_GT(watched, 0);
  EXPECT_TRUE(seen->metrics.completed);
  EXPECT_EQ(seen->reached.size(), stick->haptic.task.checkpoints.size());
  EXPECT_LE(seen->way.size(), ToolFilm::kMost);
  EXPECT_NEAR(seen->way.back().time, seen->metrics.time, 0.05);
  // At each checkpoint's moment its touch point is there.
  for (std::size_t i = 0; i < seen->reached.size(); ++i) {
    const scenario::Checkpoint& place = stick->haptic.task.checkpoints[i];
    const Vec3 p_WC = tool_at(*seen, *seen->reached[i]) * stick->haptic.task.touch_point;
    EXPECT_LT((p_WC - place.position).norm(), 1.5 * place.radius) << place.name;
  }
  const std::filesystem::path file = cache.only_file();
  const std::string kept = text_of(file);
  EXPECT_LT(kept.size(), kMostExpertBytes);

  const std::optional<ExpertRun> again = watch();
  ASSERT_TRUE(again);
  EXPECT_EQ(watched, 0) << "it was kept";
  EXPECT_EQ(named_values(again->metrics), named_values(seen->metrics));

  nlohmann::json lie = nlohmann::json::parse(kept);
  lie["figures"]["completed"] = 0.3;
  for (const std::string& text : {lie.dump(), std::string(1'000'000, '['), std::string()}) {
    std::ofstream(file, std::ios::trunc) << text;
    const std::optional<ExpertRun> anew = watch();
    ASSERT_TRUE(anew);
    EXPECT_GT(watched, 0) << "it was not believed";
    EXPECT_EQ(named_values(anew->metrics), named_values(seen->metrics));
    EXPECT_EQ(text_of(file), kept) << "and put right";
  }
}

}  // namespace
}  // namespace fulcrum::app
