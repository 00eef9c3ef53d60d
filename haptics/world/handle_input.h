#pragma once
// The first stage of a tick: what a device's sample says of the handle. Mapping and clutch put it into the
// scene, its encoders' counts are told apart from its motion, its velocity is estimated, and so is the place
// where the hand holds it, where the scene asks for that.

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
  explicit HandleInput(const PlainScene& scene);

  void apply(const Command& command) noexcept;

  // One sample. faults: of Guard::watch(); a sample that cannot be used leaves the handle where it was. Adds
  // kHoldingPointLost.
  HandleMotion follow(const DeviceSample& sample, std::uint32_t& faults) noexcept;

  // How stiff a wall the device's structure can render where the tool is touched in this tick.
  void touch(const ContactCentroid& centroid) noexcept;

  const VelocityEstimator& velocity() const { return velocity_; }
  // Null: the scene names none.
  const HoldingPoint* holding_point() const { return holding_point_ ? &*holding_point_ : nullptr; }
  std::optional<HoldingRecord> holding() const noexcept;

private:
  Pose map(const DeviceSample& sample, bool usable) noexcept;
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

  Pose X_DH_;      // of the last sample that could be used
  Pose X_WH_;      // of the last tick
  Pose clutch_X_;  // what the clutch has added to X_WD X_DH: its way in the world, its turn on the handle's
                   // side
  bool clutched_ = false;
  bool engages_;  // with the next sample that can be used
  std::int64_t ticks_ = 0;
  double strip_ohm_ = kNoStrip;  // of this tick
  double stiffness_limit_ = 0;   // N/m, where the tool is touched in this tick; 0: nowhere, or not known
};

}  // namespace fulcrum
