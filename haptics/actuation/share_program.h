#pragma once
// How much of a force, and how much of a moment beside it, motors within their limits can make:
//     minimise    F^2 (1 - gamma)^2 + M^2 (1 - mu)^2,         gamma and mu in [0, 1]
//     subject to  low <= gamma a + mu b + N z <= high         for some z
//                 gamma <= the largest share that the device's largest force leaves
//                 |t + gamma c + mu d| <= T                   the torque about the handle
// a (motors): efforts of the whole force; b: of the whole moment; N: efforts that are not felt; t: the torque
// that is there already; c, d: that of the whole force and of the whole moment; T: the device's largest.
//
// A convex program in two unknowns once z is gone: Fourier-Motzkin elimination turns the motors' limits into
// half-planes (R. J. Duffin, "On Fourier's analysis of linear inequality systems", 1974), and the point of
// their intersection that is nearest to (1, 1) is found by adding one at a time (R. Seidel,
// "Small-dimensional linear programming and convex hulls made easy", 1991), beginning with the ellipse of the
// last line. Exact but for rounding, without a tolerance to choose, and in a fixed time.

#include <limits>

#include "haptics/actuation/motor_space.h"

namespace fulcrum {

struct ShareProblem {
  Effort force_effort = Effort::Zero(), moment_effort = Effort::Zero();  // a, b
  const MotorSpace::Spare* spare = nullptr;                              // N
  Effort low = Effort::Zero(), high = Effort::Zero();                    // low <= 0 <= high
  double force_size = 0, moment_size = 0;                                // F, M, in one unit
  double largest_force_share = 1;                                        // of gamma
  struct Torque {
    Vec3 there = Vec3::Zero(), of_force = Vec3::Zero(), of_moment = Vec3::Zero();  // (3) N m: t, c, d
    double largest = std::numeric_limits<double>::infinity();                      // N m: T, |t| <= T
  };
  Torque torque{};
};

struct Shares {
  double force = 1;                // gamma
  double moment = 1;               // mu
  Effort effort = Effort::Zero();  // the smallest z that goes with them
};

Shares solve_shares(const ShareProblem& problem) noexcept;

// One share for both: the largest s in [0, 1] with low <= s a + N z <= high for some z, and no larger than
// largest_force_share. force_effort is a; neither the moment's nor the torque is looked at.
Shares solve_common_share(const ShareProblem& problem) noexcept;

}  // namespace fulcrum
