#include "haptics/effects/torque_substitution/torque_classifier.h"

#include <cmath>

namespace fulcrum {

TorqueClassifier::TorqueClassifier(const TorqueBounds& bounds, double tick_s)
    : bounds_(bounds), hold_ticks_(std::llround(std::ceil(kHold / tick_s))) {}

bool TorqueClassifier::update(const Vec3& contact_torque, const Wrench& F_T_W) noexcept {
  if (beyond(contact_torque, F_T_W, bad_ ? kRelease : 1.0)) {
    bad_ = true;
    good_ticks_ = 0;
  } else if (bad_ && ++good_ticks_ >= hold_ticks_) {
    bad_ = false;
  }
  return bad_;
}

// part: of the bounds.
bool TorqueClassifier::beyond(const Vec3& contact_torque, const Wrench& F_T_W, double part) const noexcept {
  const double torque = F_T_W.torque.norm();
  // Not a number is neither: every comparison with it fails.
  if (!(contact_torque.norm() > part * bounds_.contact && torque > part * bounds_.torque)) return false;
  const Vec3 u = F_T_W.torque / torque;
  const Vec3 across = F_T_W.force - u * F_T_W.force.dot(u);
  return torque > part * bounds_.radius * across.norm();
}

}  // namespace fulcrum
