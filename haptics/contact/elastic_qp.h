#pragma once
// The nearest point, in a metric, to a goal, that satisfies linear inequalities; where they contradict each
// other, the one that breaks them evenly and as little as it can:
//     min  1/2 (x - g)^T diag(m) (x - g) + 1/2 rho s^2     subject to  a_i . x + s >= b_i
// A dual active-set method (D. Goldfarb, A. Idnani, "A numerically stable dual method for solving strictly
// convex quadratic programs", Mathematical Programming 27, 1983): finite and exact, indifferent to redundant
// rows; the common slack s makes every set of rows solvable.

#include <array>
#include <cstddef>
#include <span>

#include "haptics/math/linear.h"

namespace fulcrum {

inline constexpr std::size_t kMaxRows = 256;

struct QpRow {
  Vec6 a = Vec6::Zero();  // (6)
  double b = 0;
};

class ElasticQp {
public:
  static constexpr std::size_t kMaxActive = 7;  // rows that push at once: the motion's six and the slack

  // metric: (6) diag(m), each positive. slack: rho, positive and large beside the metric over the rows.
  ElasticQp(const Vec6& metric, double slack);

  // Another metric from the next solve() on.
  void set_metric(const Vec6& metric) noexcept { per_root_metric_ = metric.cwiseSqrt().cwiseInverse(); }

  struct Solution {
    Vec6 x = Vec6::Zero();
    bool exact = true;  // false: the iterations ran out; x is the best so far
    int iterations = 0;
  };
  // rows: at most kMaxRows; the rest are not looked at. multipliers: (rows) receives the force of each row,
  // >= 0, m (x - g) = sum_i multiplier_i a_i. What it holds before is a guess: rows above zero are tried as
  // active first. The answer is the same, sooner.
  Solution solve(const Vec6& goal, std::span<const QpRow> rows, std::span<double> multipliers) noexcept;

private:
  static constexpr int kDimension = static_cast<int>(kMaxActive);
  using Vec7 = Eigen::Matrix<double, kDimension, 1>;
  using Mat7 = Eigen::Matrix<double, kDimension, kDimension>;

  struct Active {
    std::size_t row = 0;
    double multiplier = 0;
  };
  // A row beside the active ones.
  struct Split {
    Vec7 along;   // its coordinates in the basis
    Vec7 beyond;  // the part of it that no active row spans
    bool independent;
  };
  Vec7 start(const Vec7& goal, std::span<const double> multipliers) noexcept;
  void scale(std::span<const QpRow> rows) noexcept;
  Split split(const Vec7& c) const noexcept;
  void activate(std::size_t row, double multiplier, const Split& parts) noexcept;
  void deactivate(int which) noexcept;
  Vec7 over_triangle(const Vec7& v) const noexcept;
  Vec7 over_transposed(const Vec7& v) const noexcept;

  Vec6 per_root_metric_;
  double per_root_slack_;
  std::array<Vec7, kMaxRows> c_;      // rows over the root of the metric, unit
  std::array<double, kMaxRows> b_{};  // their right sides, scaled alike
  std::array<double, kMaxRows> scale_{};
  std::array<Active, kDimension> active_{};
  int active_count_ = 0;
  Mat7 basis_;     // orthonormal columns, as many as rows are active
  Mat7 triangle_;  // upper: active row j is basis_ times its column j
};

}  // namespace fulcrum
