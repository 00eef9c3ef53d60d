#pragma once
// A device with nothing behind it but the test: tick by tick a sample in, and a push out. A push goes the way
// that a run's forces go, through HandleOutput with its ramp, clamp, slew limit, stop, allocation and output
// limit; only that the largest force and torque are the test's, which are smaller.

#include <functional>
#include <string>

#include "engine/app/device_test/pace.h"
#include "haptics/device/device.h"
#include "haptics/world/handle_output.h"

namespace fulcrum::app::device_test {

// What a test may ask of a device's motors: enough to be felt, and no more.
struct PushBudget {
  explicit PushBudget(const DeviceDesc& device);
  double force = 0;   // N: a fifth of the device's largest, 1 N at most; 0: it has no such motors
  double torque = 0;  // N m: a fifth of the device's largest, 0.05 N m at most
};

struct BenchTick {
  double time = 0;  // s
  DeviceSample sample;
  bool fresh = false;      // it is another one than in the tick before
  Wrench commanded_F_H_D;  // on the handle about H
};

class TestBench {
public:
  // ends: someone wants the test to end now.
  TestBench(Device& device, double tick_s, Pace pace, std::function<bool()> ends);

  // One tick that pushes so, and vibrates so.
  const BenchTick& tick(const Wrench& wanted_F_H_D = {}, const VibrotactileCommand& vibrotactile = {});

  // The test cannot go on: a fault has stopped the force, or someone wants it to end.
  bool over() const { return output_.stopped() || ends_(); }
  bool stopped() const { return output_.stopped(); }
  // What stopped it, in sentences; empty: nothing did.
  std::string why_stopped() const;

  const PushBudget& budget() const { return budget_; }
  const DeviceDesc& desc() const { return device_.desc(); }
  double tick_s() const { return tick_s_; }
  double largest_age() const { return largest_age_; }  // s, of all samples so far
  // How often samples stayed away for longer than patience().
  int dropouts() const { return dropouts_; }
  double patience() const { return patience_; }  // s

private:
  void look_at(const DeviceSample& sample, double time);

  Device& device_;
  double tick_s_;
  Pace pace_;
  std::function<bool()> ends_;
  PushBudget budget_;
  HandleOutput output_;
  BenchTick tick_;
  Pose X_DH_;  // by the last sample that could be used
  bool first_ = true, away_ = false;
  double measured_at_ = 0;  // s, when the newest sample's pose was
  double patience_;
  double largest_age_ = 0;
  int dropouts_ = 0;
  std::uint32_t faults_ = 0;  // that stopped it
};

}  // namespace fulcrum::app::device_test
