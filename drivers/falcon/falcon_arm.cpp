#include "drivers/falcon/falcon_arm.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "drivers/falcon/falcon_packets.h"
#include "haptics/math/functions.h"

namespace fulcrum::falcon {
namespace {

constexpr double kRadian = std::numbers::pi / 180;
constexpr double kAnglePerCount = .036435 * kRadian, kAngleAtZero = 35 * kRadian;
// m, by Stamper's letters.
constexpr double kA = .060;                // the arm
constexpr double kB = .1025;               // the shin
constexpr double kD = .01125, kE = kD;     // across the joints at the shin's two ends
constexpr double kC = .01443, kF = -.025;  // from the shin to the grip's middle: outward, sideways
constexpr double kR = .040, kS = -.02309;  // from the base's middle to the arm: outward, sideways
constexpr std::array<double, 3> kLegs{105 * kRadian, -15 * kRadian, -135 * kRadian};

constexpr double kLeastAngle = -90 * kRadian, kMostAngle = 120 * kRadian;  // beyond any that a leg can turn
constexpr int kSteps = 12;                // Newton's; six are enough anywhere in the workspace
constexpr double kLongestStep = 0.03;     // m
constexpr double kClosed = 1e-9;          // m, what may be left of a gap in a leg
constexpr double kLeastBend = 0.05;       // sine of the angle between arm and shin
constexpr double kLeastSpread = 0.05;     // of the shins' directions: the volume that they span
constexpr double kMotorPerTorque = -1e4;  // 1/(N m)

// A leg at a guess of the grip's place. The shin's length closes the loop: how far it is from kB is its gap.
struct Leg {
  Vec3 along_D;     // (3) unit, the shin, towards the grip
  double gap;       // m
  double by_angle;  // m/rad, what the leg's angle adds to the gap
  double bend;      // sine of the angle between arm and shin
};

Leg leg_at(const Vec3& p_K, double direction, double angle) {
  const double cos = math::cos(direction), sin = math::sin(direction);
  const Vec3 out(cos, sin, 0), side(-sin, cos, 0);
  // From the arm's end to where the shin's far joint is.
  const double u = out.dot(p_K) - kR + kC - kA * math::cos(angle);
  const double v = side.dot(p_K) - kS + kF;
  const double w = p_K.z() - kA * math::sin(angle);
  // Across both joints first; what is left, with what lies sideways, is the shin.
  const double across = std::max(std::sqrt(u * u + w * w), 1e-6);
  const double shin = across - (kD + kE);
  const double length = std::max(std::sqrt(shin * shin + v * v), 1e-6);
  Leg leg;
  leg.along_D = (shin * u / across * out + v * side + shin * w / across * Vec3::UnitZ()) / length;
  leg.gap = length - kB;
  leg.bend = (w * math::cos(angle) - u * math::sin(angle)) / across;
  leg.by_angle = -kA * leg.bend * shin / length;
  return leg;
}

std::array<Leg, 3> legs_at(const Vec3& p_K, const std::array<double, 3>& angles) {
  return {leg_at(p_K, kLegs[0], angles[0]), leg_at(p_K, kLegs[1], angles[1]),
          leg_at(p_K, kLegs[2], angles[2])};
}

Mat3 rows_of(const std::array<Leg, 3>& legs) {
  Mat3 rows;
  rows << legs[0].along_D.transpose(), legs[1].along_D.transpose(), legs[2].along_D.transpose();
  return rows;
}

// On the axis of the base, where the legs' angles are all their mean.
Vec3 begin_at(const std::array<double, 3>& angles) {
  const double mean = (angles[0] + angles[1] + angles[2]) / 3;
  const double u = kC - kR - kA * math::cos(mean), v = kF - kS;
  const double across = kD + kE + std::sqrt(kB * kB - v * v);
  return {0, 0, kA * math::sin(mean) + std::sqrt(std::max(across * across - u * u, 1e-4))};
}

}  // namespace

std::optional<Stance> stance_at(const std::array<int, 3>& counts) noexcept {
  std::array<double, 3> angles{};
  for (std::size_t i = 0; i < angles.size(); ++i) {
    angles[i] = kAngleAtZero + kAnglePerCount * counts[i];
    if (angles[i] < kLeastAngle || angles[i] > kMostAngle) return std::nullopt;
  }
  Vec3 p_K = begin_at(angles);
  for (int step = 0; step < kSteps; ++step) {
    const std::array<Leg, 3> legs = legs_at(p_K, angles);
    const Mat3 rows = rows_of(legs);
    if (std::abs(rows.determinant()) < 1e-3) return std::nullopt;
    Vec3 by = -(rows.inverse() * Vec3(legs[0].gap, legs[1].gap, legs[2].gap));
    if (const double length = by.norm(); length > kLongestStep) by *= kLongestStep / length;
    p_K += by;
  }
  const std::array<Leg, 3> legs = legs_at(p_K, angles);
  const Mat3 rows = rows_of(legs);
  if (std::abs(rows.determinant()) < kLeastSpread) return std::nullopt;
  Vec3 by_angle;
  for (std::size_t i = 0; i < legs.size(); ++i) {
    if (!(std::abs(legs[i].gap) < kClosed) || legs[i].bend < kLeastBend) return std::nullopt;
    by_angle[static_cast<Eigen::Index>(i)] = legs[i].by_angle;
  }
  return Stance{p_K - Vec3(0, 0, kMiddle), rows.inverse() * (-by_angle).asDiagonal()};
}

std::array<int, 3> motors_for(const Stance& stance, const Vec3& F_H_D) noexcept {
  if (!F_H_D.allFinite()) return {};
  // Forces beyond any device's, which scaling would make infinite.
  const Vec3 force = F_H_D.cwiseMax(-1e6).cwiseMin(1e6);
  Vec3 value = kMotorPerTorque * (stance.J_D.transpose() * force);
  if (const double most = value.cwiseAbs().maxCoeff(); most > kMostMotor) value *= kMostMotor / most;
  std::array<int, 3> motors{};
  for (std::size_t i = 0; i < motors.size(); ++i)
    motors[i] = static_cast<int>(std::lround(value[static_cast<Eigen::Index>(i)]));
  return motors;
}

}  // namespace fulcrum::falcon
