#include "haptics/device/linear_loop.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>
#include <cmath>

#include "haptics/math/border.h"

namespace fulcrum {
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
  constexpr Eigen::Index kOwn = 4;
  const Eigen::Index delay = loop.delay_ticks, size = kOwn + delay;
  // State: x, v, x_before, u_before, then the forces that wait, the next to act first.
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(size, size);
  A(0, 0) = 1;
  A(0, 1) = held.x_v;
  A(1, 1) = held.v_v;
  A(2, 0) = 1;
  Eigen::RowVectorXd velocity = Eigen::RowVectorXd::Zero(size);
  velocity[0] = (1 - loop.keep) / T;
  velocity[2] = -velocity[0];
  velocity[3] = loop.keep;
  A.row(3) = velocity;
  Eigen::RowVectorXd force = -wall.B * velocity;
  force[0] -= wall.K;
  if (delay == 0) {
    A.row(0) += held.x_F * force;
    A.row(1) += held.v_F * force;
  } else {
    A(0, kOwn) = held.x_F;
    A(1, kOwn) = held.v_F;
    for (Eigen::Index i = kOwn; i + 1 < size; ++i) A(i, i + 1) = 1;
    A.row(size - 1) = force;
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

}  // namespace fulcrum
