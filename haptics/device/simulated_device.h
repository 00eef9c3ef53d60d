#pragma once
// A 6/3-DOF or 6-DOF device in a simulated hand: handle inertia, friction, encoder steps, force limits,
// sample age and bus delay. A device like any other; its time is the tick's.

#include <array>
#include <optional>

#include "haptics/device/device.h"
#include "haptics/device/friction_axis.h"
#include "haptics/device/hand.h"
#include "haptics/device/held_handle.h"
#include "haptics/device/holding_strip.h"
#include "haptics/device/mapping.h"

namespace fulcrum {

struct SimulatedDeviceDesc {
  DeviceDesc device;
  double tick_s = 1e-3;
  int sample_age_ticks = 0;  // 0 to 8: how old a pose is when it is read
  int bus_delay_ticks = 0;   // 0 to 2: how late a command reaches the motors
};

// What the hand does: where it wants the tool, and how the tool lies in it.
struct HandTask {
  HandPath path;
  HandDesc hand;
  Pose X_HT;
  MappingDesc mapping;
  Vec3 sag_W = Vec3::Zero();  // (3) m, how far the tool hangs below the handle by its weight: a person aims
                              // so much higher
  Vec3 stick_H = Vec3::UnitX();  // (3) unit, along which the path says where it is held
  Vec3 carried_D =
      Vec3::Zero();  // (3) N, the weight that the hand has learnt to carry, as a force on the handle
};

class SimulatedDevice final : public Device {
public:
  SimulatedDevice(const SimulatedDeviceDesc& desc, HandTask task);
  // In no hand: free, at X_DH.
  SimulatedDevice(const SimulatedDeviceDesc& desc, const Pose& X_DH);

  const DeviceDesc& desc() const override { return desc_.device; }
  DeviceSample read() noexcept override;
  void write(const DeviceCommand& command) noexcept override;
  void miss(int ticks) noexcept override;

  const Pose& X_DH() const { return X_DH_; }  // the true pose, not the encoders'
  Vec3 velocity() const {                     // (3) m/s, in D
    return held_ ? held_->velocity() : Vec3(axes_[0].v, axes_[1].v, axes_[2].v);
  }
  // Of a hand whose path says where it holds the stick; null for others.
  const HeldHandle* held() const { return held_ ? &*held_ : nullptr; }
  void push(const Vec3& v_D) noexcept;  // sets the handle's velocity, m/s

private:
  struct HandTarget {
    Pose X_DH;
    Vec6 rate = Vec6::Zero();  // (6) m/s; rad/s
  };
  // At that time, and how fast it goes on in the next `step` s of the path: 0 while it waits.
  HandTarget hand_target(double time, double step) const noexcept;
  void advance(const Wrench& F_H_D, const DeviceCommand::Cues& cues) noexcept;
  void advance_held(const Wrench& F_H_D, const HandTarget& target) noexcept;
  void advance_axes(const Wrench& F_H_D, const HandTarget& target) noexcept;
  void hold_elsewhere();
  void measure() noexcept;

  SimulatedDeviceDesc desc_;
  bool turns_alike_;  // about every axis
  std::optional<HandTask> task_;
  std::optional<Tremor> tremor_;
  std::optional<Yielding> yielding_;
  double time_ = 0;
  Vec3 drifted_W_ = Vec3::Zero();  // (3) m, of the mapping, as the hand sees it by the tool
  std::optional<SimulatedStrip> strip_;
  Pose X_DH_;
  Pose measured_;
  // Translation in D; rotation about the axes of D, or of H where they differ, x from the pose at the tick's
  // start.
  std::array<FrictionAxis, 6> axes_;
  std::optional<HeldHandle>
      held_;  // in place of the axes, where the hand holds the stick elsewhere than at H
  static constexpr std::size_t kDelay = 9;
  struct Seen {
    Pose X_DH;
    double strip_ohm = kNoStrip;
  };
  std::array<Seen, kDelay> seen_{};
  std::array<DeviceCommand, kDelay> sent_{};
  std::size_t at_ = 0;
};

}  // namespace fulcrum
