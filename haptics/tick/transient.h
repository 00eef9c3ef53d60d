#pragma once
// A wrench that no slew limit slows down, because it is there to be sudden.

#include <cstddef>
#include <optional>

#include "haptics/math/wrench.h"

namespace fulcrum {

// What asks for such wrenches, in the order in which the motors serve them. What each may do is in
// safety/transient_budget.h.
enum class TransientSource : std::size_t { braking_pulse, torque_substitution, impact_vibration };
inline constexpr std::size_t kTransientSources =
    static_cast<std::size_t>(TransientSource::impact_vibration) + 1;  // the last

// Where a hand holds the handle away from its origin it feels p_HG x f - m beside the force f.
struct Grasp {
  Vec3 p_HG_D = Vec3::Zero();  // (3) m
  double lever = 0;            // m, of a moment counted beside a force
  bool moment = false;         // where motors lack force a moment may stand in for it: Allocator::pulse
};

// What an effect asks for in one tick. Without a grasp its budget bounds it first, and motors then render it
// whole or the same part of force and torque. With one it may be far beyond all motors: what they can do of
// it is found first, and its budget bounds that.
struct Transient {
  TransientSource source = TransientSource::braking_pulse;
  Wrench F_H_D;  // on the handle about H
  std::optional<Grasp> grasp{};
};

}  // namespace fulcrum
