#include "haptics/actuation/share_program.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace fulcrum {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kZeroRow = 1e-13;  // of a row whose largest coefficient is 1
constexpr double kMinSize = 1e-9;   // of F beside M and the other way about: neither share is left undecided

// row . (u, v, z1, z2) <= bound, with u = F (1 - gamma) and v = M (1 - mu).
struct Bound {
  std::array<double, 4> row;
  double bound;
};

// Each unknown that is gone squares half the count: 16 from eight motors, 64, 1024; and the box.
class Bounds {
public:
  void add(const Bound& b) noexcept {
    double largest = 0;
    for (const double c : b.row) largest = std::max(largest, std::abs(c));
    if (largest <= kZeroRow * (1 + std::abs(b.bound))) return;  // holds or fails whatever the unknowns are
    Bound& kept = all_[count_++];
    for (std::size_t i = 0; i < 4; ++i) kept.row[i] = b.row[i] / largest;
    kept.bound = b.bound / largest;
  }
  std::size_t size() const { return count_; }
  const Bound& operator[](std::size_t i) const { return all_[i]; }

private:
  static constexpr std::size_t kCapacity = 32 * 32 + 8;
  std::array<Bound, kCapacity> all_;
  std::size_t count_ = 0;
};

void eliminate(const Bounds& from, std::size_t unknown, Bounds& to) noexcept {
  for (std::size_t p = 0; p < from.size(); ++p) {
    const double c = from[p].row[unknown];
    if (std::abs(c) <= kZeroRow) to.add(from[p]);
    if (c <= kZeroRow) continue;
    for (std::size_t n = 0; n < from.size(); ++n) {
      const double d = from[n].row[unknown];
      if (d >= -kZeroRow) continue;
      Bound sum{};
      for (std::size_t i = 0; i < 4; ++i) sum.row[i] = from[p].row[i] / c - from[n].row[i] / d;
      sum.row[unknown] = 0;
      sum.bound = from[p].bound / c - from[n].bound / d;
      to.add(sum);
    }
  }
}

struct Point {
  double x = 0, y = 0;
};

// The points where |c + x a + y b| <= largest: the whole plane, a strip or an ellipse with what is within.
class TorqueBound {
public:
  TorqueBound() = default;
  TorqueBound(const Vec3& c, const Vec3& a, const Vec3& b, double largest)
      : c_(c), a_(a), b_(b), square_(largest * largest) {}

  bool holds(const Point& at) const { return (c_ + at.x * a_ + at.y * b_).squaredNorm() <= square_; }

  // The nearest of them to the origin: x = -s (I + s J^T J)^-1 J^T c of the least s >= 0 that is enough, J =
  // [a b].
  Point nearest() const noexcept {
    if (holds({})) return {};
    const double aa = a_.squaredNorm(), bb = b_.squaredNorm(), ab = a_.dot(b_);
    const double half = 0.5 * (aa - bb), root = std::sqrt(half * half + ab * ab);
    const double q1 = 0.5 * (aa + bb) + root, q2 = std::max(0.0, 0.5 * (aa + bb) - root);
    Eigen::Vector2d e = half > 0 ? Eigen::Vector2d(half + root, ab) : Eigen::Vector2d(ab, root - half);
    e = e.norm() > 0 ? Eigen::Vector2d(e.normalized()) : Eigen::Vector2d::UnitX();
    const Eigen::Vector2d g(a_.dot(c_), b_.dot(c_)), across(-e.y(), e.x());
    const double g1 = e.dot(g), g2 = across.dot(g);
    const auto at = [&](double s) {
      const Eigen::Vector2d x = -s / (1 + s * q1) * g1 * e - s / (1 + s * q2) * g2 * across;
      return Point{x.x(), x.y()};
    };
    double low = 0, high = q1 > 0 ? 1 / q1 : 1;
    for (int i = 0; i < kDoublings && !holds(at(high)); ++i) {
      low = high;
      high *= 4;
    }
    for (int i = 0; i < kHalvings; ++i) {
      const double middle = 0.5 * (low + high);
      (holds(at(middle)) ? high : low) = middle;
    }
    return at(high);
  }

  // From where to where along foot + t direction they reach.
  std::array<double, 2> along(const Point& foot, const Point& direction) const noexcept {
    if (square_ == kInfinity) return {-kInfinity, kInfinity};
    const Vec3 at = c_ + foot.x * a_ + foot.y * b_, d = direction.x * a_ + direction.y * b_;
    const double A = d.squaredNorm(), B = at.dot(d), C = at.squaredNorm() - square_;
    if (A <= kZeroRow * kZeroRow * square_)
      return {-kInfinity, kInfinity};  // it does not change along this line
    const double root = std::sqrt(std::max(0.0, B * B - A * C));
    return {(-B - root) / A, (-B + root) / A};
  }

private:
  static constexpr int kDoublings = 60, kHalvings = 60;
  Vec3 c_ = Vec3::Zero(), a_ = Vec3::Zero(), b_ = Vec3::Zero();
  double square_ = kInfinity;
};

// The point nearest to the origin with row[first] x + row[first + 1] y <= bound for all of them, and the
// torque's.
Point nearest(const Bounds& bounds, std::size_t first, const TorqueBound& torque = {}) noexcept {
  Point at = torque.nearest();
  for (std::size_t i = 0; i < bounds.size(); ++i) {
    const double a = bounds[i].row[first], b = bounds[i].row[first + 1], c = bounds[i].bound;
    const double squared = a * a + b * b;
    if (a * at.x + b * at.y <= c || squared <= kZeroRow) continue;
    // On this line then: its foot, moved as little as the bounds before it ask for.
    const Point foot{a * c / squared, b * c / squared};
    auto [low, high] = torque.along(foot, {-b, a});
    for (std::size_t j = 0; j < i; ++j) {
      const double p = bounds[j].row[first], q = bounds[j].row[first + 1];
      const double slope = -b * p + a * q;
      const double room = bounds[j].bound - (p * foot.x + q * foot.y);
      if (slope > kZeroRow) high = std::min(high, room / slope);
      if (slope < -kZeroRow) low = std::max(low, room / slope);
    }
    const double along = low <= high ? std::clamp(0.0, low, high) : 0.5 * (low + high);  // by rounding alone
    at = {foot.x - b * along, foot.y + a * along};
  }
  return at;
}

// The smallest efforts that are not felt and bring `effort` within its limits.
void settle(const ShareProblem& problem, Effort& effort) noexcept {
  const MotorSpace::Spare& spare = *problem.spare;
  Bounds bounds;
  for (int m = 0; m < effort.size(); ++m) {
    bounds.add({{spare(m, 0), spare(m, 1), 0, 0}, problem.high[m] - effort[m]});
    bounds.add({{-spare(m, 0), -spare(m, 1), 0, 0}, effort[m] - problem.low[m]});
  }
  const Point z = nearest(bounds, 0);
  effort += spare * Eigen::Vector2d(z.x, z.y);
  effort = effort.cwiseMax(problem.low).cwiseMin(problem.high);
}

// Limits of `whole + u du + v dv + N z`, each motor's divided by its own.
void bound_motors(const ShareProblem& problem, const Effort& whole, const Effort& du, const Effort& dv,
                  Bounds& bounds) noexcept {
  const MotorSpace::Spare& spare = *problem.spare;
  for (int m = 0; m < whole.size(); ++m) {
    bounds.add({{du[m], dv[m], spare(m, 0), spare(m, 1)}, problem.high[m] - whole[m]});
    bounds.add({{-du[m], -dv[m], -spare(m, 0), -spare(m, 1)}, whole[m] - problem.low[m]});
  }
}

// least, most: of u and v.
Point solve(const ShareProblem& problem, const Effort& whole, const Effort& du, const Effort& dv,
            const Point& least, const Point& most, const TorqueBound& torque) noexcept {
  Bounds with_z2, with_z1, plane;
  bound_motors(problem, whole, du, dv, with_z2);
  eliminate(with_z2, 3, with_z1);
  eliminate(with_z1, 2, plane);
  plane.add({{-1, 0, 0, 0}, -least.x});
  plane.add({{0, -1, 0, 0}, -least.y});
  plane.add({{1, 0, 0, 0}, most.x});
  plane.add({{0, 1, 0, 0}, most.y});
  return nearest(plane, 0, torque);
}

}  // namespace

Shares solve_shares(const ShareProblem& problem) noexcept {
  Shares shares;
  const double largest = std::max(problem.force_size, problem.moment_size);
  const Effort whole = problem.force_effort + problem.moment_effort;
  shares.effort = whole;
  if (largest > 0) {
    const double F = std::max(problem.force_size / largest, kMinSize);
    const double M = std::max(problem.moment_size / largest, kMinSize);
    const ShareProblem::Torque& torque = problem.torque;
    const Point short_by = solve(problem, whole, -problem.force_effort / F, -problem.moment_effort / M,
                                 {F * (1 - problem.largest_force_share), 0}, {F, M},
                                 {torque.there + torque.of_force + torque.of_moment, -torque.of_force / F,
                                  -torque.of_moment / M, torque.largest});
    shares.force = std::clamp(1 - short_by.x / F, 0.0, 1.0);
    shares.moment = std::clamp(1 - short_by.y / M, 0.0, 1.0);
    shares.effort = shares.force * problem.force_effort + shares.moment * problem.moment_effort;
  }
  settle(problem, shares.effort);
  return shares;
}

Shares solve_common_share(const ShareProblem& problem) noexcept {
  const Effort& whole = problem.force_effort;
  Shares shares;
  const Point short_by =
      solve(problem, whole, -whole, Effort::Zero(), {1 - problem.largest_force_share, 0}, {1, 0}, {});
  shares.force = shares.moment = std::clamp(1 - short_by.x, 0.0, 1.0);
  shares.effort = shares.force * whole;
  settle(problem, shares.effort);
  return shares;
}

}  // namespace fulcrum
