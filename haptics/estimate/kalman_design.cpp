// Discretisation: C. F. Van Loan, "Computing integrals involving the matrix exponential", IEEE Trans.
// Automatic Control 23(3), 1978. Riccati equation: structure-preserving doubling, E. K.-W. Chu, H.-Y. Fan,
// W.-W. Lin, C.-S. Wang, Int. J. Control 77(8), 2004: each step doubles the horizon, so that a filter that
// looks back for a million ticks takes twenty.

#include "haptics/estimate/kalman_design.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>

#include "haptics/math/functions.h"

namespace fulcrum {
namespace {

constexpr double kMinIndex = 1e-9, kMaxIndex = 1e6;
constexpr int kDoublings = 60;

using Mat8 = Eigen::Matrix<double, 8, 8>;

// exp(M) of a matrix whose norm is at most about 2.
Mat8 exponential(const Mat8& M) {
  Mat8 sum = Mat8::Identity(), term = Mat8::Identity();
  for (int n = 1; n <= 30; ++n) {
    term = term * M / n;
    sum += term;
  }
  return sum;
}

// F and Q of the continuous model dx = A x dt + white noise of density G, one tick on.
void discretise(const Mat4& A, const Mat4& G, KalmanModel& model) {
  int halvings = 0;
  for (double norm = A.cwiseAbs().maxCoeff(); norm > 1; norm /= 2) ++halvings;
  const double h = std::ldexp(1.0, -halvings);
  Mat8 M = Mat8::Zero();
  M.topLeftCorner<4, 4>() = -A;
  M.topRightCorner<4, 4>() = G;
  M.bottomRightCorner<4, 4>() = A.transpose();
  const Mat8 E = exponential(h * M);
  model.F = E.bottomRightCorner<4, 4>().transpose();
  model.Q = model.F * E.topRightCorner<4, 4>();
  for (int i = 0; i < halvings; ++i) {
    model.Q += (model.F * model.Q * model.F.transpose()).eval();
    model.F = (model.F * model.F).eval();
  }
  model.Q = (0.5 * (model.Q + model.Q.transpose())).eval();
}

// Covariance of the foretold state once it no longer changes.
Mat4 riccati(const Mat4& F, const Mat4& Q) {
  Mat4 A = F.transpose(), G = Mat4::Zero(), H = Q;
  G(0, 0) = 1;
  for (int i = 0; i < kDoublings; ++i) {
    const Mat4 W = (Mat4::Identity() + G * H).inverse();
    const Mat4 more = A.transpose() * H * W * A;
    G = (G + A * W * G * A.transpose()).eval();
    A = (A * W * A).eval();
    H += more;
    G = (0.5 * (G + G.transpose())).eval();
    H = (0.5 * (H + H.transpose())).eval();
    if (more.cwiseAbs().maxCoeff() <= 1e-17 * H.cwiseAbs().maxCoeff()) break;
  }
  return H;
}

}  // namespace

KalmanModel kalman_model(double jerk, double noise, double jerk_time, double tick_s) {
  const double index = std::clamp(jerk * tick_s * tick_s * std::sqrt(tick_s) / noise, kMinIndex, kMaxIndex);
  KalmanModel model;
  model.F_of_constant_jerk << 1, 1, 0.5, 1.0 / 6, 0, 1, 1, 0.5, 0, 0, 1, 1, 0, 0, 0, 1;
  if (jerk_time <= 0) {
    model.F.topLeftCorner<3, 3>() = model.F_of_constant_jerk.topLeftCorner<3, 3>();
    Eigen::Matrix3d spread;
    spread << 1.0 / 20, 1.0 / 8, 1.0 / 6, 1.0 / 8, 1.0 / 3, 1.0 / 2, 1.0 / 6, 1.0 / 2, 1;
    model.Q.topLeftCorner<3, 3>() = index * index * spread;
    return model;
  }
  const double decay = tick_s / jerk_time;
  Mat4 A = Mat4::Zero(), G = Mat4::Zero();
  A(0, 1) = A(1, 2) = A(2, 3) = 1;
  A(3, 3) = -decay;
  G(3, 3) = math::square(index * decay);
  discretise(A, G, model);
  return model;
}

SteadyFilter steady_filter(const KalmanModel& model, double tick_s) {
  SteadyFilter filter;
  filter.F = model.F;
  filter.P = riccati(model.F, model.Q);
  filter.gain = filter.P.col(0) / (filter.P(0, 0) + 1);
  Mat4 correct = Mat4::Identity();
  correct.col(0) -= filter.gain;
  const Mat4 loop = correct * model.F;

  // Error of the estimate: e' = loop e + correct (F_true - F) x, with x of unit jerk; steady where e' = e.
  const Vec4 missed = correct * (model.F_of_constant_jerk - model.F).col(3);
  const Vec4 error = (Mat4::Identity() - loop).lu().solve(missed);
  filter.lag = error[2] * tick_s;

  // Covariance that white measurement noise alone leaves: S = loop S loop^T + gain gain^T, by doubling.
  Mat4 S = filter.gain * filter.gain.transpose(), step = loop;
  for (int i = 0; i < kDoublings; ++i) {
    S += (step * S * step.transpose()).eval();
    step = (step * step).eval();
  }
  filter.a_rms = std::sqrt(S(2, 2));
  return filter;
}

}  // namespace fulcrum
