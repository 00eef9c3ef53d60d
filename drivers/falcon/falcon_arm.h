#pragma once
// Where a Falcon's grip is at given counts of its three legs, and which motors push it.
//
// Each leg is an arm that turns about an axis in the base and a shin, a parallelogram, to the grip, which
// therefore does not turn (R. E. Stamper, "A Three Degree of Freedom Parallel Manipulator with Only
// Translational Degrees of Freedom", 1997). Lengths and signs: libnifalcon, FalconGeometry.h.
//
// K, the frame of the legs' axes: x right, y up, z out of the base towards the person. D has its axes, and
// its origin kMiddle before the base. H has D's axes too: nothing senses how the grip is turned.

#include <array>
#include <optional>

#include "haptics/math/linear.h"

namespace fulcrum::falcon {

inline constexpr double kMiddle = 0.125;  // m, of the grip's way along z

// Where the grip is.
struct Stance {
  Vec3 p_DH;  // (3) m
  Mat3 J_D;   // (3 x 3) m/rad; columns: what each leg's angle does to p_DH
};

// None: no Falcon has such counts, or its legs are so near to a stretch or a fold that its motors could not
// be told what to do.
std::optional<Stance> stance_at(const std::array<int, 3>& counts) noexcept;

// The motors' values that make this force on the grip, N, in D. Where one would be above kMostMotor all are
// scaled alike, so that the force keeps its direction. A force that is no number makes none.
std::array<int, 3> motors_for(const Stance& stance, const Vec3& F_H_D) noexcept;

}  // namespace fulcrum::falcon
