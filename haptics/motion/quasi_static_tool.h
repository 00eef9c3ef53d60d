#pragma once
// What the two motions of a tool without mass share: the hand's goal as a small motion, the weight as an
// offset of the goal, the tool's velocity as an estimate, and a coupling that damps the handle's own mass.

#include "haptics/estimate/velocity.h"
#include "haptics/math/rotation.h"
#include "haptics/scene/plain_scene.h"
#include "haptics/tool/virtual_coupling.h"

namespace fulcrum {

class QuasiStaticTool {
public:
  explicit QuasiStaticTool(const PlainScene& desc);

  const BodyState& state() const { return state_; }
  const VirtualCoupling& coupling() const { return coupling_; }
  double weight() const { return weight_; }

  // (6) m and rad in W, about T: the motion that takes the tool to where the hand wants it.
  Vec6 to_hand(const Pose& X_WG) noexcept;
  // (6) m and rad in W, about T: the motion that takes the tool to where coupling and weight alone would have
  // it.
  Vec6 to_goal(const Pose& X_WG) noexcept;
  // Moves the tool by d (6). False, and nothing is moved: the result is not finite.
  bool move(const Vec6& d) noexcept;
  void put(const Pose& X_WT) noexcept { state_.X_WT = X_WT; }
  void limit_torque(double limit) noexcept { coupling_.limit_torque(limit); }
  // The tick's last word: the tool's velocity, from its pose as the handle's is from its own, and the wrench
  // of the coupling on the tool about T. A tool that is late, held back by no contact, or on its way back
  // from there, counts as moving with the hand: a damper between the two would push the hand on with all that
  // the tool catches up, and nothing in the scene has paid for that.
  Wrench settle(const Pose& X_WG, const Twist& V_WG, bool is_late) noexcept;

private:
  VirtualCoupling coupling_;
  VelocityEstimator velocity_;
  double tick_s_;
  BodyState state_;
  double weight_;  // N
  double sag_;     // m, how far the coupling's spring yields to the weight
  Vec3 turn_ = Vec3::Zero();
};

}  // namespace fulcrum
