#include "haptics/contact/elastic_qp.h"

#include <Eigen/QR>
#include <algorithm>
#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

constexpr int kMaxIterations = 200;
constexpr double kSatisfied = 1e-12;    // in scaled lengths, of the goal's and the rows' own size
constexpr double kIndependent = 1e-12;  // squared length of what a unit row adds to the active ones

}  // namespace

ElasticQp::ElasticQp(const Vec6& metric, double slack)
    : root_metric_(metric.cwiseSqrt()), root_slack_(std::sqrt(slack)) {}

void ElasticQp::scale(std::span<const QpRow> rows) noexcept {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    c_[i].head<6>() = rows[i].a.cwiseQuotient(root_metric_);
    c_[i][6] = 1.0 / root_slack_;
    const double length = c_[i].norm();
    scale_[i] = 1.0 / length;
    c_[i] *= scale_[i];
    b_[i] = rows[i].b * scale_[i];
  }
}

// z: the part of c that no active row spans; r: c's coordinates in the active rows. False: z is nothing.
bool ElasticQp::project(const Vec7& c, Vec7& z, Vec7& r) const noexcept {
  r.setZero();
  z = c;
  if (active_count_ > 0) {
    Eigen::Matrix<double, kDimension, Eigen::Dynamic, 0, kDimension, kDimension> N(kDimension, active_count_);
    for (int j = 0; j < active_count_; ++j) N.col(j) = c_[active_[static_cast<std::size_t>(j)].row];
    const Eigen::HouseholderQR<decltype(N)> qr(N);
    r.head(active_count_) = qr.solve(c);
    z.noalias() -= N * r.head(active_count_);
  }
  return z.squaredNorm() > kIndependent;
}

ElasticQp::Solution ElasticQp::solve(const Vec6& goal, std::span<const QpRow> rows,
                                     std::span<double> multipliers) noexcept {
  rows = rows.first(std::min(rows.size(), kMaxRows));
  scale(rows);
  active_count_ = 0;
  Vec7 y = Vec7::Zero();
  y.head<6>() = goal.cwiseProduct(root_metric_);
  double size = y.norm();
  for (std::size_t i = 0; i < rows.size(); ++i) size = std::max(size, std::abs(b_[i]));
  const double satisfied = kSatisfied * size;

  Solution solution;
  for (;;) {
    // The row that is broken most.
    std::size_t worst = rows.size();
    double lacking = -satisfied;
    for (std::size_t i = 0; i < rows.size(); ++i) {
      const double slack = c_[i].dot(y) - b_[i];
      if (slack < lacking) {
        lacking = slack;
        worst = i;
      }
    }
    if (worst == rows.size()) break;

    double multiplier = 0;
    for (bool added = false; !added;) {
      if (++solution.iterations > kMaxIterations) {
        solution.exact = false;
        break;
      }
      Vec7 z, r;
      const bool independent = project(c_[worst], z, r) && active_count_ < kDimension;
      // As far as no active row begins to pull.
      double dual = std::numeric_limits<double>::infinity();
      int leaving = -1;
      for (int j = 0; j < active_count_; ++j) {
        const double m = active_[static_cast<std::size_t>(j)].multiplier;
        if (r[j] > 0 && m / r[j] < dual) {
          dual = m / r[j];
          leaving = j;
        }
      }
      const double primal = independent ? (b_[worst] - c_[worst].dot(y)) / z.squaredNorm()
                                        : std::numeric_limits<double>::infinity();
      const double step = std::min(dual, primal);
      if (!std::isfinite(step)) {  // rounding alone: the slack makes every row solvable
        solution.exact = false;
        break;
      }
      if (independent) y += step * z;
      for (int j = 0; j < active_count_; ++j) active_[static_cast<std::size_t>(j)].multiplier -= step * r[j];
      multiplier += step;
      if (primal <= dual) {
        active_[static_cast<std::size_t>(active_count_++)] = {worst, multiplier};
        added = true;
      } else {
        std::copy(active_.begin() + leaving + 1, active_.begin() + active_count_, active_.begin() + leaving);
        --active_count_;
      }
    }
    if (!solution.exact) break;
  }
  std::fill(multipliers.begin(), multipliers.end(), 0.0);
  for (int j = 0; j < active_count_; ++j) {
    const Active& active = active_[static_cast<std::size_t>(j)];
    multipliers[active.row] = active.multiplier * scale_[active.row];
  }
  solution.x = y.head<6>().cwiseQuotient(root_metric_);
  return solution;
}

}  // namespace fulcrum
