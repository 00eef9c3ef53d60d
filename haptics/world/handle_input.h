#pragma once
// The first stage of a tick: what a device's sample says of the handle. Mapping, clutch and drift put it into
// the scene, its encoders' counts are told apart from its motion, its velocity is estimated, and so is the
// place where the hand holds it, where the scene asks for that.

#include <cstdint>
#include <optional>

#include "haptics/contact/contact_centroid.h"
#include "haptics/estimate/encoder_motion.h"
#include "haptics/estimate/holding_point.h"
#include "haptics/estimate/holding_record.h"
#include "haptics/estimate/velocity.h"
#include "haptics/scene/plain_scene.h"
#include "haptics/tick/command.h"
#include "haptics/tick/handle_motion.h"

namespace fulcrum {

// (6) m and rad in D, of one count of the device.
Vec6 encoder_steps(const DeviceDesc& device);

class HandleInput {
public:
  // pushed_clutched: something pushes the handle while the clutch is pressed, so that its way then counts.
  explicit HandleInput(const PlainScene& scene, bool pushed_clutched = false);

  void apply(const Command& command) noexcept;

  // One sample. faults: of Guard::watch(); a sample that cannot be used leaves the handle where it was. Adds
  // kHoldingPointLost.
  HandleMotion follow(const DeviceSample& sample, std::uint32_t& faults) noexcept;

  // How stiff a wall the device's structure can render where the tool is touched in this tick.
  void touch(const ContactCentroid& centroid) noexcept;
  // Whether the tool touches nothing in this tick: in the next one the mapping may drift.
  void leave_free(bool free) noexcept { free_ = free; }

  const VelocityEstimator& velocity() const { return velocity_; }
  // Null: the scene names none.
  const HoldingPoint* holding_point() const { return holding_point_ ? &*holding_point_ : nullptr; }
  std::optional<HoldingRecord> holding() const noexcept;
  // (3) m in W, by which drift has carried the tool on since the start; none where the scene names none.
  std::optional<Vec3> drifted_W() const noexcept {
    return mapping_.drift > 0 ? std::optional(drifted_W_) : std::nullopt;
  }

private:
  Pose map(const DeviceSample& sample, bool usable) noexcept;
  void drift(bool usable) noexcept;
  Vec6 moved_at_device(const Pose& X_DH_before) const noexcept;
  void hold(double strip_ohm, std::uint32_t& faults) noexcept;

  MappingDesc mapping_;
  Pose X_HT_;
  double tick_s_;
  VelocityEstimator velocity_;
  EncoderMotion counted_;
  std::optional<HoldingPoint> holding_point_;
  std::optional<HoldingPointDesc> holding_desc_;
  std::optional<StructureDesc> structure_;
  bool has_strip_;
  Vec3 workspace_, workspace_centre_;  // (3) m, half extents; in D
  bool renders_force_, renders_torque_;
  double drift_rest_;      // m, of the handle's way, that is none
  bool counts_at_device_;  // the handle's way is told by the device, not by what the mapping makes of it

  Pose X_DH_;      // of the last sample that could be used
  Pose X_WH_;      // of the last tick
  Pose clutch_X_;  // what clutch and drift have added to X_WD X_DH: the way in the world, the turn on the
                   // handle's side
  Vec3 drifted_W_ = Vec3::Zero();       // (3) m, by drift alone
  std::optional<Vec3> drift_from_D_{};  // (3) m, where the handle was when its way was last counted
  bool known_ = false;                  // a sample before this one could be used
  bool found_anew_ = false;             // the last one could not
  bool free_ = true;                    // the tool touched nothing in the tick before
  bool clutched_ = false;
  bool reaches_ = true;  // the tool has followed the handle in this tick
  bool engages_;         // with the next sample that can be used
  std::int64_t ticks_ = 0;
  double strip_ohm_ = kNoStrip;  // of this tick
  double stiffness_limit_ = 0;   // N/m, where the tool is touched in this tick; 0: nowhere, or not known
};

}  // namespace fulcrum
