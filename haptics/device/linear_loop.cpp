#include "haptics/device/linear_loop.h"

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include "haptics/math/bisect.h"
#include "haptics/math/functions.h"

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
  if (z < 1e-6)  // to first order in z, where the closed form loses its digits
    return {T * (1 - z / 2), T * T / axis.mass * (0.5 - z / 6), 1 - z, T / axis.mass * (1 - z / 2)};
  const double gone = -math::expm1(-z), x_v = axis.mass / axis.damping * gone;
  return {x_v, (T - x_v) / axis.damping, 1 - gone, gone / axis.damping};
}

}  // namespace

double exact_growth(const WallLoop& loop, const Wall& wall, const std::optional<FreeTool>& tool) {
  const double T = loop.tick_s;
  const Held held = hold(loop.axis, T);
  // State: from the tool to the handle, the handle's v, its last way, u_before, the forces that wait, the
  // next to act first, and the tool's velocity.
  constexpr Eigen::Index kOwn = 4;
  const Eigen::Index delay = loop.delay_ticks, of_tool = kOwn + delay, size = of_tool + (tool ? 1 : 0);
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(size, size);
  Eigen::RowVectorXd velocity = Eigen::RowVectorXd::Zero(size);
  velocity[2] = (1 - loop.filter_pole) / T;
  velocity[3] = loop.filter_pole;
  Eigen::RowVectorXd force = -wall.B * velocity;
  force[0] -= wall.K;
  if (tool) force[of_tool] += wall.B;

  Eigen::RowVectorXd acts = force;
  if (delay > 0) {
    acts.setZero();
    acts[kOwn] = 1;
    for (Eigen::Index i = kOwn; i + 1 < of_tool; ++i) A(i, i + 1) = 1;
    A.row(of_tool - 1) = force;
  }
  A.row(2) = held.x_F * acts;
  A(2, 1) += held.x_v;
  A.row(0) = A.row(2);
  A(0, 0) += 1;
  A.row(1) = held.v_F * acts;
  A(1, 1) += held.v_v;
  A.row(3) = velocity;
  if (tool) {
    Eigen::RowVectorXd change = -T / tool->mass * force, during = Eigen::RowVectorXd::Zero(size);
    if (tool->integrator == Integrator::implicit_euler) {
      change = -T * force;
      change[of_tool] -= T * T * wall.K;
      change /= tool->mass + T * wall.B + T * T * wall.K;
    }
    during[of_tool] = 1;
    during += change;
    A.row(of_tool) = during;
    A.row(0) -= T * during;
  }
  const Eigen::EigenSolver<Eigen::MatrixXd> eigen(A, false);
  return 0.5 * math::log(eigen.eigenvalues().cwiseAbs2().maxCoeff()) / T;
}

double exact_stiffness_limit(const WallLoop& loop, double B) {
  return end_above(
      kSoftest, kPrecision,
      [&](double K) {
        return exact_growth(loop, {K, B}) < 0;
      });
}

double exact_damping_limit(const WallLoop& loop) {
  return end_above(
      kSoftest, kPrecision,
      [&](double B) {
        return exact_growth(loop, {kSoftest, B}) < 0;
      });
}

}  // namespace fulcrum
