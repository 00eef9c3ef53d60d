#pragma once
// The Entact W6D as "Hybrid Force-Moment Braking Pulse" has it: once as a table, the other time as the
// formulas of its Appendix I, written down on their own.

#include <array>
#include <cmath>
#include <numbers>

#include "haptics/device/device.h"

namespace fulcrum::w6d {

inline constexpr double l0 = 0.042, l1 = 0.034, l2 = 0.180, l3 = 0.165, d1 = 0.046, d2 = 0.205, d3 = 0.0697;
inline constexpr double kRatio = 0.185;

using ArmAngles = std::array<double, 3>;  // shoulder, elbow, yaw: theta_1, _2, _3 or theta_4, _5, _6

inline double rad(double deg) {
  return deg * std::numbers::pi / 180;
}
inline const ArmAngles kNominal0{rad(-36.4), rad(81.1), rad(9.44)};
inline const ArmAngles kNominal1{rad(-48.0), rad(87.0), rad(6.00)};

// Eqs. 15 to 18: (3) m, the end of arm 0 or 1 in the paper's frame.
inline Vec3 end_K(int arm, const ArmAngles& theta) {
  const double side = 2 * arm - 1;
  const auto [shoulder, elbow, yaw] = theta;
  const double reach = l2 * std::cos(shoulder) + l3 * std::cos(shoulder + elbow);
  return {side * l0 * std::sin(yaw) - d1 + reach * std::cos(yaw),
          -l1 + l2 * std::sin(shoulder) + l3 * std::sin(shoulder + elbow),
          side * l0 * std::cos(yaw) + d2 - side * d3 - reach * std::sin(yaw)};
}

// Eq. 24 by central differences: columns by shoulder, elbow, yaw, m.
inline Mat3 jacobian_K(int arm, const ArmAngles& theta) {
  constexpr double h = 1e-6;
  Mat3 J;
  for (std::size_t j = 0; j < 3; ++j) {
    ArmAngles more = theta, less = theta;
    more[j] += h;
    less[j] -= h;
    J.col(static_cast<Eigen::Index>(j)) = (end_K(arm, more) - end_K(arm, less)) / (2 * h);
  }
  return J;
}

// The paper's Eq. 26, with B of Eq. 25 as it should be: joint rates of a stylus that moves with (v, w) at its
// interaction point, in the paper's frame. (7 x 6): arm 0, arm 1, each shoulder, elbow, yaw; the spin.
inline Eigen::Matrix<double, 7, 6> inverse_jacobian_K(const ArmAngles& theta0, const ArmAngles& theta1) {
  const Vec3 between = end_K(0, theta0) - end_K(1, theta1);
  const Vec3 zhat = between.normalized();
  const auto cross = [](const Vec3& r) {
    Mat3 S;
    S << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
    return S;
  };
  Eigen::Matrix<double, 7, 6> J = Eigen::Matrix<double, 7, 6>::Zero();
  const Mat3 B0 = jacobian_K(0, theta0).inverse(), B1 = jacobian_K(1, theta1).inverse();
  J.block<3, 3>(0, 0) = B0;
  J.block<3, 3>(0, 3) = -B0 * cross(between);  // v_0 = v + w x (d_0 - d_1)
  J.block<3, 3>(3, 0) = B1;
  J.block<1, 3>(6, 3) = zhat.transpose() / kRatio;
  return J;
}

// The table. limit, twist_limit: N m.
inline DeviceDesc device(double limit, double twist_limit) {
  const auto arm = [limit](int index, const char* name, const ArmAngles& home) {
    const double side = 2 * index - 1, z_yaw = d2 - side * d3, z = z_yaw + side * l0;
    const std::string prefix = name;
    const auto joint = [&](const char* of, const Vec3& axis_K, const Vec3& point_K, double at, double low,
                           double high) {
      return JointDesc{.name = prefix + of,
                       .axis_K = axis_K,
                       .point_K = point_K,
                       .home = at,
                       .low = low,
                       .high = high,
                       .max_torque = limit};
    };
    return ArmDesc{.name = name,
                   .joints = {joint("_yaw", Vec3::UnitY(), {-d1, 0, z_yaw}, home[2], -1.2, 1.2),
                              joint("_shoulder", Vec3::UnitZ(), {-d1, -l1, z}, home[0], -1.9, 0.6),
                              joint("_elbow", Vec3::UnitZ(), {-d1 + l2, -l1, z}, home[1], 0.2, 2.8)},
                   .end_K = {-d1 + l2 + l3, -l1, z}};
  };
  DeviceDesc desc;
  desc.name = "w6d";
  desc.kinematics = Kinematics::arms;
  desc.renders_torque = true;
  desc.max_force = 6.6;
  desc.max_torque = 0.3;
  desc.mechanism.arms = {arm(1, "lower", kNominal1), arm(0, "upper", kNominal0)};
  desc.mechanism.spin = SpinDesc{.name = "twist", .ratio = kRatio, .max_torque = twist_limit};
  return desc;
}

}  // namespace fulcrum::w6d
