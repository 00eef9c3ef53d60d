// A calibration: written, read again, held to its device's table, and kept with a scenario.

#include "engine/scenario/calibration.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <fstream>
#include <string>

#include "engine/scenario/content.h"
#include "engine/scenario/load.h"
#include "tests/scenario/example.h"

namespace fulcrum::scenario::test {
namespace {

// What lies in a file of the folder.
std::filesystem::path written(const Folder& folder, const std::string& text) {
  folder.write("calibration.yaml", text);
  return folder.root() / "calibration.yaml";
}

Calibration some() {
  return {.device = "test_arm",
          .workspace = ReachedWorkspace{{0.01, -0.02, 1.0 / 3000}, {0.05, 0.03, 0.04}},
          .handle_weight = 0.1 + 0.2,
          .left_handed = true};
}

TEST(Calibration, IsReadAsItWasWritten) {
  const Folder folder;
  const auto read = load_calibration(written(folder, calibration_text(some())));
  ASSERT_TRUE(read) << to_text(read.faults());
  EXPECT_EQ(read->device, "test_arm");
  ASSERT_TRUE(read->workspace);
  EXPECT_EQ(read->workspace->centre_D, some().workspace->centre_D);
  EXPECT_EQ(read->workspace->half_extents, some().workspace->half_extents);
  EXPECT_EQ(read->handle_weight, some().handle_weight);
  EXPECT_TRUE(read->left_handed);
  const auto least = load_calibration(written(folder, calibration_text({.device = "falcon"})));
  ASSERT_TRUE(least) << to_text(least.faults());
  EXPECT_FALSE(least->workspace);
  EXPECT_FALSE(least->handle_weight);
  EXPECT_FALSE(least->left_handed);
}

TEST(Calibration, TakesThePlaceOfTheTablesFiguresAndOfNoOther) {
  const DeviceDesc table;
  const Result<DeviceDesc> device = calibrated(table, some());
  ASSERT_TRUE(device) << device.error().sentence;
  EXPECT_EQ(device->workspace_centre, Vec3(0.01, -0.02, 1.0 / 3000));
  EXPECT_EQ(device->workspace, Vec3(0.05, 0.03, 0.04));
  EXPECT_EQ(device->handle_weight, 0.1 + 0.2);
  EXPECT_EQ(device->max_force, table.max_force);
  const Result<DeviceDesc> none = calibrated(table, {.device = "x"});
  ASSERT_TRUE(none);
  EXPECT_EQ(none->handle_weight, table.handle_weight);
  EXPECT_EQ(none->workspace, table.workspace);
}

// What is safe is the table's to say: no file lets a device reach farther, or be held up by more than half of
// its force, or 1 N.
TEST(Calibration, IsHeldToTheTable) {
  const DeviceDesc table;  // 80, 60, 60 mm and 7.9 N
  Calibration farther = some();
  farther.workspace->centre_D.x() = 0.0301;
  EXPECT_NE(calibrated(table, farther).error().sentence.find("0.1 mm farther"), std::string::npos)
      << calibrated(table, farther).error().sentence;
  farther.workspace->centre_D.x() = -0.03;
  EXPECT_TRUE(calibrated(table, farther));
  Calibration heavy = some();
  heavy.handle_weight = 1.01;
  EXPECT_NE(calibrated(table, heavy).error().sentence.find("at most 1 N"), std::string::npos)
      << calibrated(table, heavy).error().sentence;
  heavy.handle_weight = 1;
  EXPECT_TRUE(calibrated(table, heavy));
  DeviceDesc weak = table;
  weak.max_force = 1.2;  // half of it holds the handle up at most
  heavy.handle_weight = 0.61;
  EXPECT_NE(calibrated(weak, heavy).error().sentence.find("at most 0.6 N"), std::string::npos);
}

TEST(Calibration, IsRefusedWithTheRemedy) {
  const Folder folder;
  const auto faults = [&](const std::string& text) {
    const auto scenario = load_scenario(folder.peg() / kScenarioFile, {}, written(folder, text));
    return scenario ? std::string() : to_text(scenario.faults());
  };
  const std::string begin = "fulcrum: 1\ndevice: test_arm\n";
  EXPECT_EQ(faults(begin), "");
  EXPECT_NE(faults(begin + "handle_weight: 9\n").find("fulcrum calibrate test_arm"), std::string::npos);
  EXPECT_NE(faults(begin + "handle_weigth: 0.1\n").find("handle_weight"), std::string::npos);
  EXPECT_NE(faults(begin + "handle_weight: .nan\n"), "");
  EXPECT_NE(faults(begin + "handle_weight: -1\n"), "");
  EXPECT_NE(faults(begin + "workspace: {centre: [0, 0, 0], half_extents: [1e-310, 0.02, 0.02]}\n"), "");
  EXPECT_EQ(faults(begin + "workspace: {centre: [0, 0, 0], half_extents: [0.02, 0.02, 0.02]}\n"), "");
  EXPECT_NE(faults("fulcrum: 1\ndevice: falcon\n").find("calibration of 'falcon'"), std::string::npos);
  EXPECT_NE(faults(begin + "# \xff\n").find("is not UTF-8"), std::string::npos) << faults(begin + "# \xff\n");
  for (const char* const bad :
       {"", "\x01", "fulcrum: 1\ndevice: falcon\n", "fulcrum: 1\ndevice: test_arm\nx: 1\n"})
    EXPECT_NE(faults(bad).find("fulcrum calibrate test_arm --forget"), std::string::npos) << faults(bad);
  EXPECT_NE(faults(begin + "workspace: {centre: [0, 0, 0]}\n"), "");
  EXPECT_NE(faults(""), "");
  EXPECT_NE(faults("\x01\x02"), "");
}

TEST(Calibration, IsKeptWithTheScenarioAndReadFromThere) {
  const Folder folder;
  const auto file = written(folder, "fulcrum: 1\ndevice: test_arm\nhandle_weight: 0.25\nleft_handed: true\n");
  const auto live = load_scenario(folder.peg() / kScenarioFile, {}, file);
  ASSERT_TRUE(live) << to_text(live.faults());
  EXPECT_EQ(live->device.desc.handle_weight, 0.25);
  EXPECT_TRUE(live->left_handed);
  std::filesystem::remove(file);
  const auto again = load_scenario_texts(live->texts, folder.peg());
  ASSERT_TRUE(again) << to_text(again.faults());
  EXPECT_EQ(again->device.desc.handle_weight, 0.25);
  EXPECT_TRUE(again->left_handed);
  const auto plain = load_scenario(folder.peg() / kScenarioFile);
  ASSERT_TRUE(plain);
  EXPECT_EQ(plain->device.desc.handle_weight, DeviceDesc{}.handle_weight);
  EXPECT_FALSE(plain->left_handed);
}

// What may not be looked at may be there: it is refused, and not passed over.
TEST(Calibration, ThatCannotBeReachedIsThere) {
  const Folder folder;
  // NOLINTBEGIN(concurrency-mt-unsafe): no thread runs yet.
  const char* const value = std::getenv("XDG_CONFIG_HOME");
  const std::string before = value != nullptr ? value : "";
  ::setenv("XDG_CONFIG_HOME", folder.root().c_str(), 1);
  EXPECT_EQ(kept_calibration("falcon"), "");
  std::filesystem::create_directory(folder.root() / "fulcrum");
  std::filesystem::create_symlink("calibration", folder.root() / "fulcrum/calibration");  // goes round
  EXPECT_EQ(kept_calibration("falcon"), folder.root() / "fulcrum/calibration/falcon.yaml");
  EXPECT_FALSE(load_calibration(kept_calibration("falcon")));
  ::setenv("XDG_CONFIG_HOME", before.c_str(), 1);  // an empty one is none
  // NOLINTEND(concurrency-mt-unsafe)
}

// Which hand is the scenario's to say, or --set's, and only where neither does the calibration's. A stick
// that a scene is held by is not mirrored, and the scene is not refused for it.
TEST(Calibration, OfALeftHandMirrorsWhereNothingElseSaysSo) {
  const Folder folder;
  const auto file = written(folder, "fulcrum: 1\ndevice: test_arm\nleft_handed: true\n");
  const std::vector<std::string> right{"left_handed=false"};
  const auto told = load_scenario(folder.peg() / kScenarioFile, right, file);
  ASSERT_TRUE(told) << to_text(told.faults());
  EXPECT_FALSE(told->left_handed);
  folder.write("scenarios/peg/scenario.yaml",
               std::string(kScenario) + "holding_point: {low: 0, high: 0.1}\n");
  const auto stick = load_scenario(folder.peg() / kScenarioFile, {}, file);
  ASSERT_TRUE(stick) << to_text(stick.faults());
  EXPECT_FALSE(stick->left_handed);
  EXPECT_NE(stick->why_right_handed.find("'holding_point'"), std::string::npos) << stick->why_right_handed;
  EXPECT_EQ(told->why_right_handed, "");
}

TEST(Calibration, ADeviceHasOneOfItsOwn) {
  // NOLINTBEGIN(concurrency-mt-unsafe): no thread runs yet.
  ::setenv("XDG_CONFIG_HOME", "/somewhere", 1);
  EXPECT_EQ(calibration_file("falcon"), "/somewhere/fulcrum/calibration/falcon.yaml");
  ::unsetenv("XDG_CONFIG_HOME");
  const char* const home = std::getenv("HOME");
  const std::string before = home != nullptr ? home : "/root";
  for (const char* const none : {"", "here"}) {  // what lies in the current folder is nobody's
    ::setenv("HOME", none, 1);
    EXPECT_EQ(calibration_file("falcon"), "");
  }
  ::setenv("HOME", before.c_str(), 1);
  // NOLINTEND(concurrency-mt-unsafe)
}

}  // namespace
}  // namespace fulcrum::scenario::test
