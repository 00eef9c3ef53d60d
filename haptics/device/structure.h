#pragma once
// How stiff a device's structure and motors can be: what bounds the stiffness of a wall that it renders.
// "Compensating device inertia for 6-DOF haptic rendering", II.C, with the distal stage's own compliance in
// series with that of its joints:
//     1 / K = 1 / K_tip + r^2 / K_theta,   for any direction   1 / K_tip + sum_i (r x n)_i^2 / K_theta_i

#include "haptics/math/linear.h"

namespace fulcrum {

struct StructureDesc {
  double tip_stiffness = 0;                 // N/m, at the handle's origin
  Vec3 angular_stiffness_H = Vec3::Zero();  // (3) N m/rad, about the handle's axes there
};

// N/m, the largest that can be rendered at p_HC (3) m along the unit normal, both in H.
inline double stiffness_at(const StructureDesc& structure, const Vec3& p_HC, const Vec3& nhat_H) {
  const Vec3 moment = p_HC.cross(nhat_H);
  const double joints = (moment.array().square() / structure.angular_stiffness_H.array()).sum();
  return 1 / (1 / structure.tip_stiffness + joints);
}

}  // namespace fulcrum
