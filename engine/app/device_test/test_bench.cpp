#include "engine/app/device_test/test_bench.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "haptics/safety/faults.h"

namespace fulcrum::app::device_test {
namespace {

constexpr double kShare = 0.2;          // of a device's largest force and torque
constexpr double kMostForce = 1;        // N
constexpr double kMostTorque = 0.05;    // N m
constexpr double kPeriods = 3;          // of a device's own, after which a sample counts as missing
constexpr double kShortestAway = 5e-3;  // s: less is the system's doing, not the device's
constexpr double kSameSample = 1e-4;    // s: its age is told no better

// A scene with nothing in it but the device. What the handle weighs is not held up: a test pushes as it says,
// and lets go in between.
SceneDesc nothing_but(const DeviceDesc& device, const PushBudget& budget, double tick_s) {
  SceneDesc scene;
  scene.tick_s = tick_s;
  scene.device = device;
  scene.device.max_force = budget.force;
  scene.device.max_torque = budget.torque;
  scene.device.handle_weight = 0;
  return scene;
}

}  // namespace

PushBudget::PushBudget(const DeviceDesc& device)
    : force(device.renders_force ? std::min(kShare * device.max_force, kMostForce) : 0),
      torque(device.renders_torque ? std::min(kShare * device.max_torque, kMostTorque) : 0) {}

TestBench::TestBench(Device& device, double tick_s, Pace pace, std::function<bool()> ends)
    : device_(device),
      tick_s_(tick_s),
      pace_(std::move(pace)),
      ends_(std::move(ends)),
      budget_(device.desc()),
      output_(nothing_but(device.desc(), budget_, tick_s)) {
  const double rate = device.desc().sample_rate_Hz;
  patience_ = std::max(kPeriods * (rate > 0 ? 1 / rate : tick_s), kShortestAway);
}

const BenchTick& TestBench::tick(const Wrench& wanted_F_H_D, const VibrotactileCommand& vibrotactile) {
  const double before = std::exchange(tick_.time, pace_());
  const auto left_out = std::lround((tick_.time - before) / tick_s_) - 1;
  if (!first_ && left_out > 0) device_.miss(static_cast<int>(std::min(left_out, 1000L)));
  tick_.sample = device_.read();
  look_at(tick_.sample, tick_.time);

  std::uint32_t faults = output_.watch(tick_.sample, {});
  output_.stop(faults);
  faults_ |= faults & kStoppingFaults;
  if (!output_.stopped()) X_DH_ = tick_.sample.X_DH;
  HandleMotion handle;
  handle.X_DH = X_DH_;
  output_.render(wanted_F_H_D, {}, handle, faults);
  output_.render_transients(Vec6::Zero(), faults);
  DeviceCommand command;
  TickRecord record;
  output_.leave(command, record);
  if (output_.stopped()) {
    command.vibrotactile.stopping = true;
    command.vibrotactile.glide = kStopFall;
  } else {
    command.vibrotactile = vibrotactile;
  }
  device_.write(command);
  tick_.commanded_F_H_D = command.F_H_D;
  first_ = false;
  return tick_;
}

void TestBench::look_at(const DeviceSample& sample, double time) {
  const double measured_at = time - sample.age;
  tick_.fresh = first_ || measured_at > measured_at_ + kSameSample;
  if (tick_.fresh) measured_at_ = measured_at;
  largest_age_ = std::max(largest_age_, sample.age);
  const bool away = sample.age > patience_ || !sample.connected;
  if (away && !away_) ++dropouts_;
  away_ = away;
}

std::string TestBench::why_stopped() const {
  std::string why;
  if (!output_.stopped()) return why;
  for (const FaultName& fault : fault_names())
    if ((faults_ & fault.bit) != 0) why.append(why.empty() ? "" : " ").append(fault.sentence);
  return why;
}

}  // namespace fulcrum::app::device_test
