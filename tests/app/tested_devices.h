#pragma once
// Devices whose faults and figures are known, and a person who answers as a test says.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "engine/app/device_test/parts.h"
#include "haptics/device/simulated_device.h"

namespace fulcrum::test {

namespace dt = app::device_test;
using dt::Answer;
using dt::Outcome;

inline constexpr double kTick = 1e-3;

inline DeviceDesc arm() {
  DeviceDesc device;
  device.max_force = 8;
  device.handle_mass = 0.1;
  device.damping = 0.05;
  device.friction = 0.04;
  device.encoder_step = 3e-5;
  device.senses_rotation = true;
  return device;
}

inline DeviceDesc pad() {
  DeviceDesc device;
  device.kinematics = Kinematics::none;
  device.renders_force = false;
  device.max_force = 0;
  device.sample_rate_Hz = 250;
  device.vibrotactile =
      VibrotactileDesc{{{.name = "left", .kind = ChannelKind::rumble, .largest = 20, .lag = 0.04},
                        {.name = "right", .kind = ChannelKind::rumble, .largest = 10, .lag = 0.02}}};
  return device;
}

// A device that does what the test here says, and keeps what it is told.
class Played final : public Device {
public:
  explicit Played(DeviceDesc desc) : desc_(std::move(desc)) {}
  const DeviceDesc& desc() const override { return desc_; }
  DeviceSample read() noexcept override {
    sample.X_DH.p = place;
    if (on_read) on_read(*this);
    ++ticks;
    return sample;
  }
  void write(const DeviceCommand& command) noexcept override { told.push_back(command); }
  void miss(int) noexcept override {}

  DeviceSample sample;
  Vec3 place = Vec3::Zero();
  std::function<void(Played&)> on_read;
  int ticks = 0;
  std::vector<DeviceCommand> told;

private:
  DeviceDesc desc_;
};

// A free handle; `wired` is what its motors make of a force.
class Free final : public Device {
public:
  explicit Free(const DeviceDesc& desc, Mat3 wired = Mat3::Identity())
      : device_({.device = desc, .tick_s = kTick}, Pose{}), wired_(std::move(wired)) {}
  const DeviceDesc& desc() const override { return device_.desc(); }
  DeviceSample read() noexcept override { return device_.read(); }
  void write(const DeviceCommand& command) noexcept override {
    told.push_back(command.F_H_D);
    DeviceCommand made = command;
    made.F_H_D.force = wired_ * command.F_H_D.force;
    made.F_H_D.torque = wired_ * command.F_H_D.torque;
    device_.write(made);
    places.push_back(device_.X_DH().p);
  }
  void miss(int) noexcept override {}

  std::vector<Wrench> told;
  std::vector<Vec3> places;  // true ones, after each tick

private:
  SimulatedDevice device_;
  Mat3 wired_;
};

// Says yes, or what the test here says; what it is asked may move the device.
class Scripted final : public dt::Person {
public:
  bool there() const override { return true; }
  void tell(std::string_view) override {}
  void ask(std::string_view question, dt::Choice) override {
    asked.emplace_back(question);
    polls_ = 0;
    if (on_ask) on_ask(asked.back());
  }
  std::optional<Answer> answer() override {
    if (++polls_ < wait) return std::nullopt;
    return says ? says(asked.back()) : Answer::yes;
  }
  int wait = 30;  // ticks until the answer
  std::function<void(const std::string&)> on_ask;
  std::function<Answer(const std::string&)> says;
  std::vector<std::string> asked;

private:
  int polls_ = 0;
};

inline dt::TestBench bench_of(
    Device& device, std::function<bool()> ends = [] { return false; }) {
  return dt::TestBench(device, kTick, dt::without_clock(kTick), std::move(ends));
}

inline dt::Findings walk_alone(Device& device) {
  dt::TestBench bench = bench_of(device);
  dt::NobodyThere nobody;
  return dt::walk(bench, nobody);
}

inline const dt::Part& part(const dt::Findings& findings, const std::string& name) {
  const auto found = std::ranges::find(findings.parts, name, &dt::Part::name);
  EXPECT_NE(found, findings.parts.end()) << "no part " << name;
  static const dt::Part none;
  return found == findings.parts.end() ? none : *found;
}

inline double measure(const dt::Part& of, const std::string& name) {
  const auto found = std::ranges::find(of.measures, name, &dt::Measure::name);
  EXPECT_NE(found, of.measures.end()) << of.name << " has no " << name;
  return found == of.measures.end() ? NAN : found->value;
}

inline constexpr const char* kPushes[] = {"push right and left", "push up and down", "push near and far"};

}  // namespace fulcrum::test
