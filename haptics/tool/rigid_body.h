#pragma once
// The tool as a rigid body, and how it moves through one tick.

#include "haptics/math/names_of.h"
#include "haptics/math/pose.h"
#include "haptics/math/wrench.h"
#include "haptics/tool/linearisation.h"

namespace fulcrum {

enum class Integrator {
  semi_implicit_euler,
  implicit_euler,
  momentum  // order 2 in rotation
};
template <>
inline constexpr std::array<std::string_view, 3> names_of<Integrator>{"semi_implicit_euler", "implicit_euler",
                                                                      "momentum"};

struct BodyState {
  Pose X_WT;
  Twist V_WT;  // of T, in W
};

class RigidBody {
public:
  // mass kg; inertia_T (3 x 3) kg m^2 about the centre of mass, symmetric positive definite.
  RigidBody(double mass, const Mat3& inertia_T);

  double mass() const { return mass_; }
  double smallest_inertia() const { return smallest_inertia_; }  // kg m^2, principal
  // kg, that a force at p_T (3) m has to move, in the direction in which that is least.
  double least_mass_at(const Vec3& p_T) const;
  Mat3 inertia_W(const Quat& q_WT) const;
  Mat3 inverse_inertia_W(const Quat& q_WT) const;
  // S with S S = I, in W: critical damping of an anisotropic body is 2 sqrt(k) S.
  Mat3 root_inertia_W(const Quat& q_WT) const;

  double kinetic_energy(const BodyState& state) const noexcept;  // J

  // Velocity after tick_s under F_T_W: semi-implicit Euler, order 1. Stable for a spring up to 4 m / tick_s^2
  // without damping, and up to .6863 m / tick_s^2 with explicit critical damping.
  Twist accelerate(const BodyState& state, const Wrench& F_T_W, double tick_s) const noexcept;

  // The same by linearly implicit Euler, order 1: (M + T B + T^2 K) dV = T (F - T K V). Stable for any
  // stiffness; what it cannot resolve in a tick it damps. D. Baraff, A. Witkin, "Large steps in cloth
  // simulation", SIGGRAPH 1998.
  Twist accelerate(const BodyState& state, const Wrench& F_T_W, const Linearisation& around,
                   double tick_s) const noexcept;

  // Semi-implicit Euler with a rotation of order 2 that keeps the angular momentum of a free body exactly:
  // the pose moves with the velocity of the middle of the tick, and what the velocity is after it follows
  // from the momentum. Where Euler's rules let a tumbling body flip at the wrong time, this one holds. S. R.
  // Buss, "Accurate and efficient simulation of rigid-body rotations", J. Computational Physics 164, 2000.
  struct Move {
    Twist during, after;
  };
  Move accelerate_keeping_momentum(const BodyState& state, const Wrench& F_T_W, double tick_s) const noexcept;

  // The pose after tick_s at a constant twist, exact for it.
  static Pose advance(const Pose& X_WT, const Twist& V_WT, double tick_s) noexcept;

private:
  double mass_;
  double smallest_inertia_;
  Mat3 inertia_T_, inverse_inertia_T_, root_inertia_T_;
};

}  // namespace fulcrum
