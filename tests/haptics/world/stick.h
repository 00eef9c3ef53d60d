#pragma once
// A stick on a ball, with known answers: a thin stick along x from the handle's origin, a ball whose distance
// is exact, and a device of 250 g with motors on every axis.

#include <cmath>
#include <memory>
#include <utility>
#include <vector>

#include "haptics/device/simulated_device.h"
#include "tests/haptics/geometry/filled_field.h"
#include "tests/haptics/scenes.h"

namespace fulcrum::test {

inline constexpr double kStickLength = 0.2;  // m
inline constexpr double kBallRadius = 0.04;  // m, of a ball about W's origin

inline std::shared_ptr<const DistanceField> ball_field() {
  static const auto field = std::make_shared<const DistanceField>(
      filled_field(14, 1e-3, [](const Vec3& p) { return p.norm() - kBallRadius; }));
  return field;
}

inline DeviceDesc stick_device() {
  DeviceDesc device;
  device.renders_torque = true;
  device.max_force = 2.5;
  device.max_torque = 0.45;
  device.handle_mass = 0.25;
  device.handle_inertia = Vec3(5e-6, 1.7e-4, 1.7e-4);
  device.handle_weight = 0;
  device.damping = 0.75;
  device.angular_damping = Vec3(1e-4, 1.25e-3, 2e-3);
  device.friction = 0.02;
  device.angular_friction = 5e-4;
  device.encoder_step = 1e-5;
  device.encoder_step_rad = 5e-5;
  device.structure = StructureDesc{.tip_stiffness = 1500, .angular_stiffness_H = Vec3(0.2, 2.5, 4.0)};
  return device;
}

// Over the ball by `height` m, which is touched at `touched` m along the stick; held at `held`.
inline SceneDesc stick_scene(double touched, double held, double height = 0.01) {
  std::vector<Vec3> points;
  for (int i = 0; i <= 400; ++i) points.emplace_back(-0.1 + 0.5e-3 * i, 0, 0);
  SceneDesc desc;
  desc.tool.mass = 0.02;
  desc.tool.inertia_T = Vec3(1e-6, 7e-5, 7e-5).asDiagonal();
  desc.tool.X_HT.p = Vec3(0.1, 0, 0);
  desc.tool.X_WT_start.p = Vec3(0.1 - touched, kBallRadius + height, 0);
  desc.tool.weight = false;
  desc.tool_shell = shell_of(points);
  desc.scene_field = ball_field();
  desc.contact.response = ContactResponse::direct;
  desc.contact.stiffness = 300;
  desc.integrator = Integrator::implicit_euler;
  desc.coupling = {
      .stiffness = 800, .angular_stiffness = 1, .damping_ratio = 1, .max_force = 2.25, .max_torque = 0.4};
  desc.device = stick_device();
  desc.holding_point = HoldingPointDesc{.place = held, .measured = false};
  return desc;
}

// Of the stick, `height` m over the ball's top: where the handle is.
inline Pose handle_over(const SceneDesc& desc, double height) {
  Pose X_WH = desc.tool.X_WT_start * desc.tool.X_HT.inverse();
  X_WH.p.y() = kBallRadius + height;
  return X_WH;
}

// A hand without tremor; the waypoints are the stick's, its centre at the given height over the ball.
inline HandTask stick_hand(const SceneDesc& desc, std::vector<Waypoint> waypoints, double mass = 0.2) {
  HandTask task{
      .path = HandPath(std::move(waypoints)), .hand = {}, .X_HT = desc.tool.X_HT, .mapping = desc.mapping};
  task.hand.tremor = task.hand.tremor_rad = 0;
  task.hand.mass = mass;
  return task;
}

inline Waypoint stick_at(const SceneDesc& desc, double height, double travel, double dwell,
                         std::optional<double> hold = {}, std::optional<double> press = {}) {
  Pose X_WT = desc.tool.X_WT_start;
  X_WT.p.y() = kBallRadius + height;
  return {.X_WT = X_WT, .travel = travel, .dwell = dwell, .hold = hold, .press = press};
}

}  // namespace fulcrum::test
