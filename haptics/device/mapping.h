#pragma once
// From the device's workspace to the scene and back.
//     p_WH = p_WD + position_scale R_WD p_DH        q_WH = q_WD q_DH
//     f_H_D = force_scale R_WD^T f_H_W              m_H_D = force_scale / position_scale R_WD^T m_H_W
// The device must render a stiffness of k * position_scale * force_scale. Rotation is not scaled; a torque is
// a force on a lever, and levers are as much shorter as ways are. So what a force and what a torque does at
// the device is the same part of what it does in the scene, force_scale / position_scale of it, and a scene
// that makes no energy makes none at the device, whichever axes a hand takes it by.

#include "haptics/math/pose.h"
#include "haptics/math/wrench.h"

namespace fulcrum {

struct MappingDesc {
  static constexpr double kMostDrift = 0.5;

  Pose X_WD;
  double position_scale = 1;
  double force_scale = 1;
  // The first sample takes hold of the tool where it is, as letting go of the clutch does: a hand need not be
  // where the scene begins.
  bool engages_at_start = false;
  int clutch_button = -1;  // while this button is down the tool stays and the handle moves freely; -1: none
  // Of the handle's way, by which the scene creeps towards the workspace's middle at most
  // (device/workspace_drift.h); 0: it does not.
  double drift = 0;

  Pose handle_in_world(const Pose& X_DH) const {
    return {X_WD.q * X_DH.q, X_WD.p + position_scale * (X_WD.q * X_DH.p)};
  }
  Pose handle_in_device(const Pose& X_WH) const {
    return {X_WD.q.conjugate() * X_WH.q, X_WD.q.conjugate() * (X_WH.p - X_WD.p) / position_scale};
  }
  Wrench wrench_in_device(const Wrench& F_H_W) const {
    return {force_scale * (X_WD.q.conjugate() * F_H_W.force),
            energy_scale() * (X_WD.q.conjugate() * F_H_W.torque)};
  }
  // d (6): a small motion or a velocity in W, translation before rotation.
  Vec6 motion_in_device(const Vec6& d) const {
    Vec6 d_D;
    d_D << X_WD.q.conjugate() * d.head<3>() / position_scale, X_WD.q.conjugate() * d.tail<3>();
    return d_D;
  }
  // Of the device, as the scene feels it: kg; kg m^2.
  double mass_in_world(double mass) const { return mass / (position_scale * force_scale); }
  double inertia_in_world(double inertia) const { return inertia / energy_scale(); }
  // J at the device for one J in the scene, and N m for one N m.
  double energy_scale() const { return force_scale / position_scale; }
  Wrench wrench_in_world(const Wrench& F_H_D) const {
    return {X_WD.q * F_H_D.force / force_scale, X_WD.q * F_H_D.torque / energy_scale()};
  }
};

}  // namespace fulcrum
