// The program itself on two devices of the kernel's: a SpaceMouse's cap takes the spanner through the pipes
// to the nut, in real time, and a DualSense beside it vibrates where the spanner is pressed against a pipe.
//
// $FULCRUM_CONTENT. Both ends are in one machine, but not in one process: fulcrum runs as a person starts it.

#include <fcntl.h>
#include <gtest/gtest.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>
#include <yaml-cpp/yaml.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "drivers/registry.h"
#include "tests/device_models/dualsense_model.h"
#include "tests/device_models/usb_hid.h"
#include "tests/drivers_kernel/cap_hand.h"
#include "tests/drivers_kernel/usbip_device.h"
#include "tests/drivers_kernel/wait_for.h"

namespace fulcrum::test {
namespace {

const std::string kOut = "/tmp/run";
constexpr const char* kSaid = "/tmp/said";  // by the program

class Program {
public:
  explicit Program(std::vector<std::string> arguments) {
    std::vector<char*> words;
    for (std::string& argument : arguments) words.push_back(argument.data());
    words.push_back(nullptr);
    posix_spawn_file_actions_t files;
    posix_spawn_file_actions_init(&files);
    posix_spawn_file_actions_addopen(&files, STDOUT_FILENO, kSaid, O_WRONLY | O_CREAT | O_TRUNC, 0644);
    posix_spawn_file_actions_adddup2(&files, STDOUT_FILENO, STDERR_FILENO);
    posix_spawnp(&id_, words[0], &files, nullptr, words.data(), environ);
    posix_spawn_file_actions_destroy(&files);
  }
  bool runs() {
    if (!ended_) ended_ = waitpid(id_, &status_, WNOHANG) != 0;
    return !ended_;
  }
  int exit_code() const { return WIFEXITED(status_) ? WEXITSTATUS(status_) : 128 + WTERMSIG(status_); }

private:
  pid_t id_ = -1;
  int status_ = 0;
  bool ended_ = false;
};

struct Waypoint {
  Pose X_WT;
  double travel_s = 0, dwell_s = 0;
};

// The way that the scenario has for an expert's hand.
std::vector<Waypoint> experts_way() {
  const YAML::Node file =
      YAML::LoadFile(std::string(std::getenv("FULCRUM_CONTENT")) + "/scenarios/piping/expert.yaml");
  std::vector<Waypoint> waypoints;
  for (const YAML::Node& node : file["waypoints"]) {
    const auto p = node["position"].as<std::array<double, 3>>();
    const auto q = node["orientation"].as<std::array<double, 4>>();
    Waypoint waypoint{
        .X_WT = {}, .travel_s = node["travel"].as<double>(0), .dwell_s = node["dwell"].as<double>(0)};
    waypoint.X_WT.p = {p[0], p[1], p[2]};
    waypoint.X_WT.q = Quat(q[0], q[1], q[2], q[3]).normalized();
    waypoints.push_back(waypoint);
  }
  return waypoints;
}

// Between the pipes, where there is no room to the side.
constexpr std::size_t kPressesAt = 4;
const Vec3 kPress{0.012, 0, 0};  // m

struct Rumble {
  std::size_t reports = 0;
  int strongest = 0, last = 0;
};
Rumble rumble_of(const HidModel& pad) {
  Rumble rumble;
  for (const Bytes& report : pad.heard()) {
    if (report.size() != 63 || (report[1] & 0x02) == 0) continue;
    ++rumble.reports;
    rumble.last = std::max(report[3], report[4]);
    rumble.strongest = std::max(rumble.strongest, rumble.last);
  }
  return rumble;
}

TEST(KernelPiping, TheCapDrivesItToTheEndAndThePadVibrates) {
  SpaceMouseModel cap;
  DualSenseModel pad(DualSenseModel::Bus::usb, 0x0224);
  UsbHid usb_cap(cap, {UsbSpeed::full, 8, false}), usb_pad(pad, {UsbSpeed::high, 6, true});
  UsbipDevice plugged_cap(usb_cap), plugged_pad(usb_pad);
  wait_for([] {
    const std::vector<DeviceListing> all = list_devices("no window");
    return std::ranges::count_if(all, [](const DeviceListing& device) {
             return device.present && (device.name == "spacemouse" || device.name == "dualsense");
           }) == 2;
  });

  Program program({"fulcrum", "run", "piping", "--headless", "--realtime", "--device", "spacemouse+dualsense",
                   "--out", kOut});
  TraceTail tail(kOut + "/trace.csv");
  CapHand hand(cap, tail, [&] { return program.runs(); });
  const std::vector<Waypoint> waypoints = experts_way();
  const Pose X_TH = waypoints.at(0).X_WT.inverse() * hand.begin();
  hand.learn();
  std::size_t before_press = 0;
  for (std::size_t i = 1; i < waypoints.size() && program.runs(); ++i) {
    const Waypoint& to = waypoints[i];
    hand.go(to.X_WT * X_TH, to.travel_s, to.dwell_s);
    if (i != kPressesAt) continue;
    before_press = rumble_of(pad).reports;
    Pose aside = to.X_WT * X_TH;
    aside.p += kPress;
    hand.go(aside, 0.5, 0.2);
    hand.go(to.X_WT * X_TH, 0.5, 0.2);
    EXPECT_GT(rumble_of(pad).reports, before_press) << "pressed against a pipe";
  }
  cap.push({});
  wait_for([&] { return !program.runs(); });
  std::cout << std::ifstream(kSaid).rdbuf() << std::flush;
  EXPECT_EQ(program.exit_code(), 0);

  std::ifstream file(kOut + "/summary.json");
  const nlohmann::json summary = nlohmann::json::parse(file, nullptr, false);
  ASSERT_TRUE(summary.is_object());
  EXPECT_TRUE(summary["completed"].get<bool>());
  EXPECT_EQ(summary["device"], "spacemouse+dualsense");
  EXPECT_TRUE(summary["faults"].empty()) << summary["faults"];
  for (const nlohmann::json& checkpoint : summary["checkpoints"])
    EXPECT_FALSE(checkpoint["reached_s"].is_null()) << checkpoint;
  const Rumble rumble = rumble_of(pad);
  EXPECT_GT(rumble.strongest, 0);
  EXPECT_EQ(rumble.last, 0) << "the motors rest at the end";
  std::printf(
      "completed in %s s; ticks: %s us, late %s, lost %s; told to rumble %zu times, at most %d of 255\n",
      summary["completion_time_s"].dump().c_str(), summary["tick_cpu_us"].dump().c_str(),
      summary["late_ticks"].dump().c_str(), summary["lost_ticks"].dump().c_str(), rumble.reports,
      rumble.strongest);
}

}  // namespace
}  // namespace fulcrum::test
