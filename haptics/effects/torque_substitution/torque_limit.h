#pragma once
// How much torque the coupling may give while the torque is bad, so that springs in contact are pressed no
// deeper by a couple than by a force.
//
// A couple between contacts a lever apart presses each with torque / lever, and a lever can be short: nothing
// else bounds it, since the hand feels nothing of it. The lever is measured, |tau_c| / (force of the region
// that is pressed hardest), and the torque held down to that lever times the coupling's largest force: what a
// region can be pressed with while the torque is good. The coupling's stiffness in rotation is lowered to
// limit / angle with it.
//
// The limit falls at once and rises only when the spring is below it: as the hand unwinds, without a jump and
// without energy. For a limit that stays, the spring with it is one of constant torque and gives back what it
// took; a limit that falls takes energy away.

#include <limits>
#include <span>

#include "haptics/contact/contact_set.h"

namespace fulcrum {

class TorqueLimit {
public:
  static constexpr double kNone = std::numeric_limits<double>::infinity();

  // largest_force: N, of the coupling. least: N m, to which the limit falls at most.
  TorqueLimit(double largest_force, double least) : largest_force_(largest_force), least_(least) {}

  // torque: N m, what full stiffness gives. contact_torque: N m, of the scene about T. Answers the limit from
  // the next tick on.
  double update(bool bad, double torque, double contact_torque,
                std::span<const ContactRegion> regions) noexcept;

private:
  double largest_force_, least_;
  double limit_ = kNone;
};

}  // namespace fulcrum
