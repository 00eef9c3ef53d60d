#include "tools/content/ear/passage.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <functional>
#include <limits>
#include <queue>

#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Eigen::Vector4d;

constexpr double first_depth = -14.0;  // mm: the tip is still outside
constexpr double pinned = 0.3;         // mm, how far a tip may lie from a stop
constexpr double most_lean = 0.7;      // rad
constexpr double lean_scale = 0.1;     // rad, that is tried where 1 mm aside is

std::vector<PassageStation> make_stations(const Canal& canal) {
  std::vector<PassageStation> stations;
  const auto pass = [&](double from, double to) {
    for (double depth = from; depth < to - 1e-9; depth += 1.0) stations.push_back({canal.middle(depth)});
  };
  const auto stop = [&](const Vector3d& tip, const char* name) { stations.push_back({tip, name}); };
  const auto over_drum = [&](double x, double y, double height) {
    return Vector3d(canal.X_WD() * Vector3d(x, y, canal.drum_height(x, y) + height));
  };
  pass(first_depth, 0.0);
  stop(canal.middle(0.0), "canal opening");
  pass(1.0, 5.0);
  stop(canal.middle(5.0), "first bend");
  pass(6.0, 20.0);
  // Where the bent end then lies, not in the middle.
  stop(canal.middle(20.0) + Vector3d(0.6, -0.9, 0.0), "second bend");
  pass(21.0, 22.5);
  const Vector3d umbo = over_drum(0.0, 0.0, 0.95);
  const Vector3d recess = over_drum(1.5, -1.2, 1.2);
  stop(umbo, "over the umbo");
  stations.push_back({0.5 * (umbo + recess)});
  stop(recess, "front recess");
  return stations;
}

Vector4d packed(const NeedlePose& pose) {
  return {pose.aside.x(), pose.aside.y(), pose.lean.x() / lean_scale, pose.lean.y() / lean_scale};
}

NeedlePose unpacked(const Vector4d& v, double roll) {
  return {v.head<2>(), lean_scale * v.tail<2>(), roll};
}

// Along each of four axes and each of their pairs, both ways.
std::vector<Vector4d> directions() {
  std::vector<Vector4d> all;
  for (int i = 0; i < 4; ++i) {
    for (const double s : {1.0, -1.0}) {
      all.emplace_back(s * Vector4d::Unit(i));
      for (int j = 0; j < i; ++j)
        for (const double t : {0.7, -0.7})
          all.emplace_back(0.7 * s * Vector4d::Unit(i) + t * Vector4d::Unit(j));
    }
  }
  return all;
}

}  // namespace

Eigen::Isometry3d placed(const PassageStation& station, const NeedlePose& pose) {
  Eigen::Isometry3d X_WT = Eigen::Isometry3d::Identity();
  const Vector3d lean(pose.lean.x(), pose.lean.y(), 0.0);
  if (lean.norm() > 1e-12) X_WT.linear() = turn_by(lean.norm(), lean.normalized()).toRotationMatrix();
  X_WT.linear() *= turn_by(pose.roll, Vector3d::UnitZ()).toRotationMatrix();
  X_WT.translation() = station.tip_W + Vector3d(pose.aside.x(), pose.aside.y(), 0.0);
  return X_WT;
}

Eigen::Isometry3d on_the_way(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to, double part) {
  static const Vector3d p_TC = needle_centre() / mm;
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear() =
      slerp(Eigen::Quaterniond(from.linear()), Eigen::Quaterniond(to.linear()), part).toRotationMatrix();
  X.translation() = (1.0 - part) * (from * p_TC) + part * (to * p_TC) - X.linear() * p_TC;
  return X;
}

Passage::Passage(const Flesh& flesh)
    : room_(flesh), needle_(needle_balls()), stations_(make_stations(flesh.canal())) {
  constexpr std::array<double, 5> leans{0.0, 0.3, -0.3, 0.0, 0.0};
  cells_.resize(stations_.size() * rolls);
  for (std::size_t s = 0; s < stations_.size(); ++s) {
    for (int r = 0; r < rolls; ++r) {
      const double roll = 2.0 * pi * r / rolls;
      std::vector<NeedlePose> from;
      for (std::size_t k = 0; k < leans.size(); ++k)
        from.push_back({Vector2d::Zero(), {leans[k], leans[(k + 2) % leans.size()]}, roll});
      if (s > 0) from.push_back(cell(s - 1, r).pose);
      if (r > 0) from.push_back(cell(s, r - 1).pose);
      Cell& best = cells_[s * rolls + static_cast<std::size_t>(r)];
      for (NeedlePose& start : from) {
        start.roll = roll;
        const Cell found = improved(s, start);
        if (preference(found) > preference(best)) best = found;
      }
    }
  }
}

const Passage::Cell& Passage::cell(std::size_t station, int roll) const {
  return cells_[station * rolls + static_cast<std::size_t>((roll + rolls) % rolls)];
}

double Passage::clearance(std::size_t station, int roll) const {
  return cell(station, roll).clearance;
}

double Passage::clearance_at(const Eigen::Isometry3d& X_WT) const {
  return room_.clearance(needle_, X_WT, -1e3);
}

// What is better of two poses: more room; where there is plenty, a shaft that leans less.
double Passage::preference(const Cell& cell) {
  constexpr double plenty = 1.0;
  const double beyond = std::max(cell.clearance - plenty, 0.0);
  return std::min(cell.clearance, plenty) + 0.1 * beyond -
         0.4 * cell.pose.lean.norm() * std::min(beyond, 0.3);
}

// R. Hooke and T. Jeeves, "Direct search solution of numerical and statistical problems", 1961.
Passage::Cell Passage::improved(std::size_t station, const NeedlePose& from) const {
  static const std::vector<Vector4d> ways = directions();
  const PassageStation& at = stations_[station];
  const double reach = at.stop.empty() ? 6.0 : pinned;
  const auto allowed = [&](const NeedlePose& pose) {
    return pose.aside.norm() <= reach && pose.lean.norm() <= most_lean;
  };
  Vector4d best = packed(from);
  if (!at.stop.empty()) best.head<2>().setZero();
  const auto look = [&](const NeedlePose& pose, double least) {
    return Cell{pose, room_.clearance(needle_, placed(at, pose), least)};
  };
  Cell found = look(unpacked(best, from.roll), -1e3);
  for (double step = 0.8; step > 0.02;) {
    bool moved = false;
    for (const Vector4d& way : ways) {
      const NeedlePose pose = unpacked(best + step * way, from.roll);
      if (!allowed(pose)) continue;
      const Cell other = look(pose, std::min(found.clearance, 1.0));
      if (preference(other) <= preference(found) + 1e-4) continue;
      best = packed(pose);
      found = other;
      moved = true;
    }
    if (!moved) step *= 0.5;
  }
  return found;
}

Passage::Fixed Passage::best_fixed_roll() const {
  Fixed best{-1e3, 0};
  for (int r = 0; r < rolls; ++r) {
    double narrowest = 1e3;
    for (std::size_t s = 0; s < stations_.size(); ++s) narrowest = std::min(narrowest, clearance(s, r));
    if (narrowest > best.clearance) best = {narrowest, r};
  }
  return best;
}

// The least room between two poses of neighbouring cells.
double Passage::between(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) const {
  double least = 1e3;
  for (const double part : {0.25, 0.5, 0.75})
    least = std::min(least, clearance_at(on_the_way(from, to, part)));
  return least;
}

// E. Dijkstra's shortest way over the cells, where a step is longer the less room it has.
std::vector<Passage::Node> Passage::way() const {
  const std::size_t n = cells_.size();
  std::vector<double> cost(n, std::numeric_limits<double>::infinity());
  std::vector<std::size_t> before(n, n);
  using Entry = std::pair<double, std::size_t>;
  std::priority_queue<Entry, std::vector<Entry>, std::greater<>> open;
  for (std::size_t r = 0; r < rolls; ++r) {
    cost[r] = 0.0;
    open.emplace(0.0, r);
  }
  const auto step_to = [&](std::size_t from, std::size_t to, double length) {
    const Cell& b = cells_[to];
    const double room = std::min(b.clearance, between(placed(stations_[from / rolls], cells_[from].pose),
                                                      placed(stations_[to / rolls], b.pose)));
    if (room < 0.05) return;
    const double lean = (cells_[from].pose.lean - b.pose.lean).norm();
    const double c = cost[from] + (length + 4.0 * lean) * (1.0 + math::pow(0.7 / room, 3.0));
    if (c >= cost[to]) return;
    cost[to] = c;
    before[to] = from;
    open.emplace(c, to);
  };
  std::size_t goal = n;
  while (!open.empty()) {
    const auto [so_far, at] = open.top();
    open.pop();
    if (so_far > cost[at]) continue;
    const std::size_t row = at / rolls * rolls;
    if (row + rolls == n) {
      goal = at;
      break;
    }
    step_to(at, row + (at - row + 1) % rolls, 0.6);
    step_to(at, row + (at - row + rolls - 1) % rolls, 0.6);
    step_to(at, at + rolls, 1.0);
  }
  std::vector<Node> nodes;
  for (std::size_t at = goal; at < n; at = before[at]) nodes.push_back({at / rolls, cells_[at].pose});
  std::reverse(nodes.begin(), nodes.end());
  return nodes;
}

}  // namespace fulcrum::content
