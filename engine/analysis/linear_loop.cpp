#include "engine/analysis/linear_loop.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <cmath>

#include "engine/analysis/border.h"

namespace fulcrum::analysis {
namespace {

constexpr double kSoftest = 1e-3;    // N/m, where the search begins
constexpr double kPrecision = 1e-9;  // of the limit

// x and v after a tick: x' = x + x_v v + x_F F, v' = v_v v + v_F F.
struct Held {
  double x_v, x_F, v_v, v_F;
};

Held hold(const DeviceAxis& axis, double T) {
  const double z = axis.damping * T / axis.mass;
  if (z < 1e-6) {  // to first order in z, where the closed form loses its digits
    return {T * (1 - z / 2), T * T / axis.mass * (0.5 - z / 6), 1 - z, T / axis.mass * (1 - z / 2)};
  }
  const double gone = -std::expm1(-z), x_v = axis.mass / axis.damping * gone;
  return {x_v, (T - x_v) / axis.damping, 1 - gone, gone / axis.damping};
}

}  // namespace

double exact_growth(const WallLoop& loop, const Wall& wall) {
  const double T = loop.tick_s;
  const Held held = hold(loop.axis, T);
  const Eigen::Index delay = loop.delay_ticks, size = 3 + delay;
  const double on_x = -wall.K - wall.B / T, on_before = wall.B / T;
  // State: x, v, x_before, then the forces that wait, the next to act first.
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(size, size);
  A(0, 0) = 1;
  A(0, 1) = held.x_v;
  A(1, 1) = held.v_v;
  A(2, 0) = 1;
  if (delay == 0) {
    A(0, 0) += held.x_F * on_x;
    A(0, 2) += held.x_F * on_before;
    A(1, 0) += held.v_F * on_x;
    A(1, 2) += held.v_F * on_before;
  } else {
    A(0, 3) = held.x_F;
    A(1, 3) = held.v_F;
    for (Eigen::Index i = 3; i + 1 < size; ++i) A(i, i + 1) = 1;
    A(size - 1, 0) = on_x;
    A(size - 1, 2) = on_before;
  }
  const Eigen::EigenSolver<Eigen::MatrixXd> eigen(A, false);
  return std::log(eigen.eigenvalues().cwiseAbs().maxCoeff()) / T;
}

double exact_stiffness_limit(const WallLoop& loop, double B) {
  return border_above(kSoftest, kPrecision, [&](double K) { return exact_growth(loop, {K, B}) < 0; });
}

double exact_damping_limit(const WallLoop& loop) {
  return border_above(kSoftest, kPrecision, [&](double B) { return exact_growth(loop, {kSoftest, B}) < 0; });
}

}  // namespace fulcrum::analysis
