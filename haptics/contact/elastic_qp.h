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
  // metric: (6) diag(m), each positive. slack: rho, positive and large beside the metric over the rows.
  ElasticQp(const Vec6& metric, double slack);

  struct Solution {
    Vec6 x = Vec6::Zero();
    bool exact = true;  // false: the iterations ran out; x is the best so far
    int iterations = 0;
  };
  // rows: at most kMaxRows; the rest are not looked at. multipliers: (rows) receives the force of each row,
  // >= 0, m (x - g) = sum_i multiplier_i a_i.
  Solution solve(const Vec6& goal, std::span<const QpRow> rows, std::span<double> multipliers) noexcept;

private:
  static constexpr int kDimension = 7;
  using Vec7 = Eigen::Matrix<double, kDimension, 1>;

  struct Active {
    std::size_t row = 0;
    double multiplier = 0;
  };
  void scale(std::span<const QpRow> rows) noexcept;
  bool project(const Vec7& c, Vec7& z, Vec7& r) const noexcept;

  Vec6 root_metric_;
  double root_slack_;
  std::array<Vec7, kMaxRows> c_;      // rows over the root of the metric, unit
  std::array<double, kMaxRows> b_{};  // likewise
  std::array<double, kMaxRows> scale_{};
  std::array<Active, kDimension> active_{};
  int active_count_ = 0;
};

}  // namespace fulcrum
