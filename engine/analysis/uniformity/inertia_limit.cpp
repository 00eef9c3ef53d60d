#include "engine/analysis/uniformity/inertia_limit.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/math/bisect.h"
#include "haptics/math/functions.h"

namespace fulcrum::analysis::uniformity {
namespace {

constexpr double kUnlimited = std::numeric_limits<double>::infinity();
constexpr double kPrecision = 1e-4;  // of a limit
constexpr double kMinJerk = 1e-3;    // of a filter whose unit of noise is 1 um: a second of lag
constexpr double kMaxJerk = 1e6;     // of the same filter: a tick of lag
constexpr double kUnit = 1e-6;       // m, of the filter's states; no eigenvalue knows it
constexpr int kMaxTicks = 200;

// Motion over a tick under a held force: s' = A s + B F, s = (x, v).
struct Tick {
  Eigen::Matrix2d A;
  Eigen::Vector2d B;
};

// Exact, by the matrix exponential of [[0 1 0] [-k/m -b/m 1/m] [0 0 0]] T.
Tick tick_of(const InertiaLoop& loop) {
  const double mass = loop.device_mass + loop.hand_mass;
  Eigen::Matrix3d M = Eigen::Matrix3d::Zero();
  M << 0, 1, 0, -loop.hand_stiffness / mass, -loop.damping / mass, 1 / mass, 0, 0, 0;
  M *= loop.tick_s;
  // In units of a tick's way, so that no entry is far larger than the others.
  Eigen::Vector3d unit(1, 1 / loop.tick_s, 1);
  M = (unit.cwiseInverse().asDiagonal() * M * unit.asDiagonal()).eval();
  int halvings = 0;
  for (double norm = M.cwiseAbs().maxCoeff(); norm > 0.5; norm /= 2) ++halvings;
  M /= std::ldexp(1.0, halvings);
  Eigen::Matrix3d E = Eigen::Matrix3d::Identity(), term = E;
  for (int n = 1; n <= 20; ++n) {
    term = term * M / n;
    E += term;
  }
  for (int i = 0; i < halvings; ++i) E = (E * E).eval();
  E = (unit.asDiagonal() * E * unit.cwiseInverse().asDiagonal()).eval();
  return {E.topLeftCorner<2, 2>(), E.topRightCorner<2, 1>()};
}

double growth_of(const Eigen::MatrixXd& A, double tick_s) {
  const Eigen::EigenSolver<Eigen::MatrixXd> eigen(A, false);
  return 0.5 * math::log(eigen.eigenvalues().cwiseAbs2().maxCoeff()) / tick_s;
}

SteadyFilter filter_of(double jerk, double tick_s) {
  return steady_filter(kalman_model(jerk, kUnit, 0, tick_s), tick_s);
}

}  // namespace

double growth(const InertiaLoop& loop, const SteadyFilter& filter) {
  const Tick tick = tick_of(loop);
  // State: x and v T in the filter's unit, then the filter's estimate before this tick's sample.
  Mat4 correct = Mat4::Identity();
  correct.col(0) -= filter.gain;
  const Mat4 kept = correct * filter.F;
  const double unit_force = loop.gain * loop.device_mass / (loop.tick_s * loop.tick_s);  // per m
  Eigen::RowVectorXd force(6);                                                           // N per m
  force << -loop.wall_stiffness + unit_force * filter.gain[2], 0, unit_force * kept.row(2);
  const Eigen::Vector2d unit(1, 1 / loop.tick_s);
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(6, 6);
  A.topLeftCorner<2, 2>() = unit.cwiseInverse().asDiagonal() * tick.A * unit.asDiagonal();
  A.topRows<2>() += unit.cwiseInverse().asDiagonal() * tick.B * force;
  A.block<4, 1>(2, 0) = filter.gain;
  A.bottomRightCorner<4, 4>() = kept;
  return growth_of(A, loop.tick_s);
}

double growth(const InertiaLoop& loop, int ticks) {
  const Tick tick = tick_of(loop);
  const double mass = loop.device_mass + loop.hand_mass;
  // State: x, v, then u, what was held in the tick before, then the accelerations of earlier ticks, newest
  // first. At a tick, before its force acts: a = (u_before - b v - k x) / mass.
  const Eigen::Index past = 3, size = past + ticks;
  Eigen::RowVectorXd a = Eigen::RowVectorXd::Zero(size), u = Eigen::RowVectorXd::Zero(size);
  a.head<3>() << -loop.hand_stiffness / mass, -loop.damping / mass, 1 / mass;
  u[0] = -loop.wall_stiffness;
  u[size - 1] = loop.gain * loop.device_mass;
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(size, size);
  A.topLeftCorner<2, 2>() = tick.A;
  A.topRows<2>() += tick.B * u;
  A.row(2) = u;
  A.row(past) = a;
  for (Eigen::Index i = past + 1; i < size; ++i) A(i, i - 1) = 1;
  return growth_of(A, loop.tick_s);
}

double first_order_lag(const InertiaLoop& loop) {
  const double left = loop.hand_mass + (1 - loop.gain) * loop.device_mass;
  return left * loop.damping / (loop.gain * loop.device_mass * (loop.hand_stiffness + loop.wall_stiffness));
}

double largest_filter_lag(const InertiaLoop& loop) {
  const auto unstable = [&loop](double jerk) { return growth(loop, filter_of(jerk, loop.tick_s)) >= 0; };
  // From the quickest filter on, to the first that is too slow.
  if (unstable(kMaxJerk)) return 0;
  for (double jerk = kMaxJerk; jerk > kMinJerk; jerk /= 2)
    if (unstable(jerk / 2)) return filter_of(bisect(jerk / 2, jerk, kPrecision, unstable), loop.tick_s).lag;
  return kUnlimited;
}

double largest_delay(const InertiaLoop& loop) {
  for (int ticks = 1; ticks <= kMaxTicks; ++ticks)
    if (growth(loop, ticks) >= 0) return (ticks - 1) * loop.tick_s;
  return kUnlimited;
}

}  // namespace fulcrum::analysis::uniformity
