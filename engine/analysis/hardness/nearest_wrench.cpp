#include "engine/analysis/hardness/nearest_wrench.h"

#include <Eigen/Dense>
#include <cmath>
#include <vector>

namespace fulcrum::analysis::hardness {
namespace {

constexpr double kKept = 1e4;      // what a newton beside the direction counts, where that is kept
constexpr double kAtRest = 1e-10;  // of |A^T b|: a smaller gradient is none
constexpr int kMaxRounds = 200;

Mat3 cross_matrix(const Vec3& r) {
  Mat3 S;
  S << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
  return S;
}

}  // namespace

Eigen::VectorXd bounded_least_squares(const Eigen::MatrixXd& A, const Eigen::VectorXd& b,
                                      const Eigen::VectorXd& limits) {
  using Index = Eigen::Index;
  const Index n = A.cols();
  Eigen::VectorXd x = Eigen::VectorXd::Zero(n);
  std::vector<int> bound(static_cast<std::size_t>(n), 0);  // -1, 1: at a limit
  const auto at = [&bound](Index i) -> int& { return bound[static_cast<std::size_t>(i)]; };
  const double small = kAtRest * (A.transpose() * b).norm();
  for (int round = 0; round < kMaxRounds; ++round) {
    std::vector<Index> free;
    for (Index i = 0; i < n; ++i)
      if (at(i) == 0) free.push_back(i);
    // Towards the solution of those that are free, as far as the first limit.
    Eigen::VectorXd wanted;
    if (!free.empty()) wanted = A(Eigen::all, free).completeOrthogonalDecomposition().solve(b - A * x);
    double step = 1;
    Index met = -1;
    for (std::size_t k = 0; k < free.size(); ++k) {
      const Index i = free[k];
      const double move = wanted[static_cast<Index>(k)], end = move > 0 ? limits[i] : -limits[i];
      if (std::abs(x[i] + move) <= limits[i] || move == 0) continue;
      if (const double part = (end - x[i]) / move; part < step || met < 0) {
        step = std::min(step, part);
        met = i;
      }
    }
    for (std::size_t k = 0; k < free.size(); ++k) x[free[k]] += step * wanted[static_cast<Index>(k)];
    if (met >= 0) {
      at(met) = x[met] > 0 || (x[met] == 0 && limits[met] == 0) ? 1 : -1;
      x[met] = at(met) * limits[met];
      continue;
    }
    // The one at a limit that would gain most by leaving it.
    const Eigen::VectorXd downhill = A.transpose() * (b - A * x);
    Index leaves = -1;
    for (Index i = 0; i < n; ++i) {
      if (at(i) == 0 || limits[i] == 0 || downhill[i] * at(i) >= -small) continue;
      if (leaves < 0 || std::abs(downhill[i]) > std::abs(downhill[leaves])) leaves = i;
    }
    if (leaves < 0) break;
    at(leaves) = 0;
  }
  return x;
}

Wrench nearest_wrench(const Actuators& motors, const Vec3& f_D, const Vec3& p_HG_D, bool keep_direction) {
  const WrenchMatrix& G = motors.wrenches();
  const auto count = static_cast<Eigen::Index>(motors.count());
  const Eigen::MatrixXd forces = G.topRows<3>().leftCols(count);
  Eigen::MatrixXd torques = G.bottomRows<3>().leftCols(count);
  if (motors.rows() == 3) torques.setZero();
  const double lever = p_HG_D.norm();
  const Vec3 nhat = f_D.normalized();
  const Mat3 weight =
      keep_direction ? Mat3(nhat * nhat.transpose() + kKept * (Mat3::Identity() - nhat * nhat.transpose()))
                     : Mat3(Mat3::Identity());
  Eigen::MatrixXd A(6, count);
  A << weight * forces, (cross_matrix(p_HG_D) * forces - torques) / lever;
  Eigen::VectorXd b(6);
  b << f_D, p_HG_D.cross(f_D) / lever;
  const Eigen::VectorXd effort = bounded_least_squares(A, b, motors.limits().head(count));
  return {forces * effort, torques * effort};
}

}  // namespace fulcrum::analysis::hardness
