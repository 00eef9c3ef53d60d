#include "haptics/contact/elastic_qp.h"

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
    : per_root_metric_(metric.cwiseSqrt().cwiseInverse()), per_root_slack_(1.0 / std::sqrt(slack)) {}

void ElasticQp::scale(std::span<const QpRow> rows) noexcept {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    c_[i].head<6>() = rows[i].a.cwiseProduct(per_root_metric_);
    c_[i][6] = per_root_slack_;
    scale_[i] = 1.0 / c_[i].norm();
    c_[i] *= scale_[i];
    b_[i] = rows[i].b * scale_[i];
  }
}

// By Gram and Schmidt, twice: once leaves rounding in what is nearly spanned.
ElasticQp::Split ElasticQp::split(const Vec7& c) const noexcept {
  Split parts{Vec7::Zero(), c, true};
  for (int pass = 0; pass < 2; ++pass) {
    for (int j = 0; j < active_count_; ++j) {
      const double part = basis_.col(j).dot(parts.beyond);
      parts.along[j] += part;
      parts.beyond -= part * basis_.col(j);
    }
  }
  parts.independent = active_count_ < kDimension && parts.beyond.squaredNorm() > kIndependent;
  return parts;
}

void ElasticQp::activate(std::size_t row, double multiplier, const Split& parts) noexcept {
  const double length = parts.beyond.norm();
  triangle_.col(active_count_) = parts.along;
  triangle_(active_count_, active_count_) = length;
  basis_.col(active_count_) = parts.beyond / length;
  active_[static_cast<std::size_t>(active_count_++)] = {row, multiplier};
}

// The basis from there on is made anew: seven columns at most.
void ElasticQp::deactivate(int which) noexcept {
  const int count = active_count_ - 1;
  std::copy(active_.begin() + which + 1, active_.begin() + active_count_, active_.begin() + which);
  for (active_count_ = which; active_count_ < count;) {
    const Active kept = active_[static_cast<std::size_t>(active_count_)];
    activate(kept.row, kept.multiplier, split(c_[kept.row]));
  }
}

ElasticQp::Vec7 ElasticQp::over_triangle(const Vec7& v) const noexcept {
  Vec7 x = Vec7::Zero();
  for (int i = active_count_ - 1; i >= 0; --i) {
    double sum = v[i];
    for (int j = i + 1; j < active_count_; ++j) sum -= triangle_(i, j) * x[j];
    x[i] = sum / triangle_(i, i);
  }
  return x;
}

ElasticQp::Vec7 ElasticQp::over_transposed(const Vec7& v) const noexcept {
  Vec7 x = Vec7::Zero();
  for (int i = 0; i < active_count_; ++i) {
    double sum = v[i];
    for (int j = 0; j < i; ++j) sum -= triangle_(j, i) * x[j];
    x[i] = sum / triangle_(i, i);
  }
  return x;
}

// The nearest point to the goal that meets the guessed rows exactly, less those that would have to pull.
ElasticQp::Vec7 ElasticQp::start(const Vec7& goal, std::span<const double> multipliers) noexcept {
  active_count_ = 0;
  for (std::size_t i = 0; i < multipliers.size() && active_count_ < kDimension; ++i) {
    if (!(multipliers[i] > 0)) continue;
    const Split parts = split(c_[i]);
    if (parts.independent) activate(i, 0, parts);
  }
  while (active_count_ > 0) {
    Vec7 lacking = Vec7::Zero();
    for (int j = 0; j < active_count_; ++j) {
      const std::size_t row = active_[static_cast<std::size_t>(j)].row;
      lacking[j] = b_[row] - c_[row].dot(goal);
    }
    const Vec7 along = over_transposed(lacking);
    const Vec7 forces = over_triangle(along);
    int pulls = 0;
    for (int j = 1; j < active_count_; ++j)
      if (forces[j] < forces[pulls]) pulls = j;
    if (forces[pulls] >= 0) {
      for (int j = 0; j < active_count_; ++j) active_[static_cast<std::size_t>(j)].multiplier = forces[j];
      return goal + basis_.leftCols(active_count_) * along.head(active_count_);
    }
    deactivate(pulls);
  }
  return goal;
}

ElasticQp::Solution ElasticQp::solve(const Vec6& goal, std::span<const QpRow> rows,
                                     std::span<double> multipliers) noexcept {
  rows = rows.first(std::min(rows.size(), kMaxRows));
  scale(rows);
  Vec7 y = Vec7::Zero();
  y.head<6>() = goal.cwiseQuotient(per_root_metric_);
  double size = y.norm();
  for (std::size_t i = 0; i < rows.size(); ++i) size = std::max(size, std::abs(b_[i]));
  const double satisfied = kSatisfied * size;
  y = start(y, multipliers.first(std::min(multipliers.size(), rows.size())));

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
      const Split parts = split(c_[worst]);
      const Vec7 r = over_triangle(parts.along);
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
      const double primal = parts.independent ? (b_[worst] - c_[worst].dot(y)) / parts.beyond.squaredNorm()
                                              : std::numeric_limits<double>::infinity();
      const double step = std::min(dual, primal);
      if (!std::isfinite(step)) {  // rounding alone: the slack makes every row solvable
        solution.exact = false;
        break;
      }
      if (parts.independent) y += step * parts.beyond;
      for (int j = 0; j < active_count_; ++j) active_[static_cast<std::size_t>(j)].multiplier -= step * r[j];
      multiplier += step;
      if (primal <= dual) {
        activate(worst, multiplier, parts);
        added = true;
      } else {
        deactivate(leaving);
      }
    }
    if (!solution.exact) break;
  }
  std::fill(multipliers.begin(), multipliers.end(), 0.0);
  for (int j = 0; j < active_count_; ++j) {
    const Active& active = active_[static_cast<std::size_t>(j)];
    multipliers[active.row] = active.multiplier * scale_[active.row];
  }
  solution.x = y.head<6>().cwiseProduct(per_root_metric_);
  return solution;
}

}  // namespace fulcrum
