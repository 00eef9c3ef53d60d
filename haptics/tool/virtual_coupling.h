#pragma once
// Virtual coupling: a spring and damper in six axes between where the hand wants the tool and where the tool
// is. Its springs meet in T, or in a point G where the hand holds the tool. J. E. Colgate, M. C. Stanley, J.
// M. Brown, "Issues in the haptic display of tool use", IROS 1995; W. A. McNeely, K. D. Puterbaugh, J. J.
// Troy, "Voxel-based 6-DOF haptic rendering improvements", Haptics-e 3(7), 2006.

#include <limits>

#include "haptics/math/pose.h"
#include "haptics/math/wrench.h"
#include "haptics/tool/rigid_body.h"

namespace fulcrum {

struct CouplingDesc {
  double stiffness = 800;          // N/m
  double angular_stiffness = 1.5;  // N m/rad
  double damping_ratio = 1;        // of critical, both
  double max_force = 6;            // N, the saturation F_s of the spring
  double max_torque = 0.3;         // N m, at which it saturates in rotation
};

class VirtualCoupling {
public:
  VirtualCoupling(const CouplingDesc& desc, const RigidBody& tool);
  // Held elsewhere than at T, see hold_at(). longest_grip (3) m, in T: as far from it as it will be.
  VirtualCoupling(const CouplingDesc& desc, const RigidBody& tool, const Vec3& longest_grip);

  // From the next pull on: the spring is at G, p_TG (3) m in T, instead of at T, and its damper with it.
  void hold_at(const Vec3& p_TG) noexcept {
    p_TG_ = p_TG;
    held_at_T_ = false;
  }

  // F_T_W, the wrench on the tool about T. X_WG, V_WG: where and how fast the hand wants the tool. Springs
  // saturate as F_s (1 - exp(-k |d| / F_s)); a rotation past pi keeps the direction it was wound up in, up to
  // 2 pi.
  Wrench pull(const Pose& X_WG, const Twist& V_WG, const BodyState& tool) noexcept;

  // From the next pull on: the torque about where the tool is held is no larger than this, N m; infinity for
  // no limit. The spring's energy is then that of a spring of constant torque beyond it.
  void limit_torque(double limit) noexcept { torque_limit_ = limit; }
  double torque_limit() const { return torque_limit_; }

  // Of the last pull (3): N m about T, what it would have been without a limit; rad, by which the spring is
  // wound.
  Vec3 full_torque() const { return held_at_T_ ? full_torque_ : Vec3(full_torque_ + moment_); }
  const Vec3& turn() const { return rotation_; }

  // Of the last pull(): tangent stiffness of the saturated springs, and the dampers.
  void linearise(const BodyState& tool, Linearisation& around) const noexcept;

  // Energy in the springs at the last pull(), J.
  double stored() const noexcept;

private:
  Wrench pull_at_grip(const Pose& X_WG, const Twist& V_WG, const BodyState& tool) noexcept;

  CouplingDesc desc_;
  double damping_;          // N s/m
  double angular_damping_;  // 2 zeta sqrt(k_R): times the root of the inertia
  RigidBody tool_;
  bool held_at_T_ = true;
  Vec3 p_TG_ = Vec3::Zero();         // (3) m, in T
  Vec3 lever_W_ = Vec3::Zero();      // (3) m, the same in W, at the last pull
  Vec3 moment_ = Vec3::Zero();       // (3) N m, of the force there about T
  Vec3 offset_ = Vec3::Zero();       // (3) m, of the last pull
  Vec3 rotation_ = Vec3::Zero();     // (3) rad, of the last pull, as a rotation vector
  double pulls_ = 0, twists_ = 0;    // of the springs' limits, at the last pull
  Vec3 full_torque_ = Vec3::Zero();  // (3) N m, of the last pull, before torque_limit_
  double torque_limit_ = std::numeric_limits<double>::infinity();  // N m
};

// F_s (1 - exp(-k |d| / F_s)) d / |d|: a spring that yields at F_s. d (3), k per unit of d.
Vec3 saturated_spring(const Vec3& d, double stiffness, double limit) noexcept;
// part: of the limit that the force is, 0 to 1.
Vec3 saturated_spring(const Vec3& d, double stiffness, double limit, double& part) noexcept;
// J, by that part: k |d| over the limit is -log(1 - part).
double saturated_spring_energy(double length, double stiffness, double limit, double part) noexcept;
double saturated_spring_energy(double length, double stiffness, double limit) noexcept;

}  // namespace fulcrum
