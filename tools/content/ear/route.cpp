#include "tools/content/ear/route.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

#include "haptics/math/rotation.h"

namespace fulcrum::content {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

constexpr double sphere = 0.8 * mm;      // radius of a checkpoint
constexpr double rest = 3.6;             // s at each
constexpr double outside = 0.03;         // m/s, of the tip before the canal
constexpr double slow = 0.005;           // m/s, in it
constexpr double turning = 0.5;          // rad/s
constexpr double kept_share = 0.85;      // of the room that the way has node by node
constexpr double room_enough = 1.2;      // mm
const Vector3d start(-12.0, 8.0, 46.0);  // mm, of the tip

Isometry3d in_metres(Isometry3d X) {
  X.translation() *= mm;
  return X;
}

// The least room (mm) on the straight way between two poses.
double room_between(const Passage& passage, const Isometry3d& a, const Isometry3d& b) {
  constexpr int steps = 12;
  double least = room_enough;
  for (int k = 0; k <= steps; ++k) {
    const Isometry3d X_WT = on_the_way(a, b, static_cast<double>(k) / steps);
    least = std::min(least, passage.clearance_at(X_WT));
  }
  return least;
}

double turn_between(const Isometry3d& a, const Isometry3d& b) {
  return angle_between(Eigen::Quaterniond(a.linear()), Eigen::Quaterniond(b.linear()));
}

}  // namespace

std::vector<RoutePose> make_route(const Passage& passage) {
  const std::vector<Passage::Node> nodes = passage.way();
  if (nodes.empty()) return {};
  std::vector<Isometry3d> poses;  // mm
  for (const Passage::Node& node : nodes)
    poses.push_back(placed(passage.stations()[node.station], node.pose));
  // The stop that a node is at: the last node of that station, when the roll is done.
  const auto stop_at = [&](std::size_t i) -> std::string {
    const bool last = i + 1 == nodes.size() || nodes[i + 1].station != nodes[i].station;
    return last ? passage.stations()[nodes[i].station].stop : "";
  };
  std::vector<RoutePose> route;
  RoutePose first{.note = "start", .X_WT = in_metres(poses.front()), .dwell = 0.5};
  first.X_WT.translation() = start * mm;
  route.push_back(first);
  const auto go = [&](std::size_t i) {
    RoutePose pose{.note = stop_at(i), .X_WT = in_metres(poses[i])};
    const Isometry3d& before = route.back().X_WT;
    const double way = (pose.X_WT.translation() - before.translation()).norm();
    const double pace = nodes[i].station == 0 ? outside : slow;
    pose.travel = std::max({0.3, 1.6 * way / pace, 1.6 * turn_between(before, pose.X_WT) / turning});
    pose.dwell = pose.note.empty() ? 0.0 : rest;
    route.push_back(pose);
  };
  for (std::size_t i = 0; i < poses.size();) {
    go(i);
    // As far as the straight way keeps most of the room, but not past a stop.
    std::size_t next = i + 1;
    double room = next < poses.size() ? room_between(passage, poses[i], poses[next]) : 0.0;
    for (std::size_t j = next; j + 1 < poses.size() && stop_at(j).empty(); ++j) {
      room = std::min(room, room_between(passage, poses[j], poses[j + 1]));
      if (room_between(passage, poses[i], poses[j + 1]) < kept_share * room) break;
      next = j + 1;
    }
    i = next;
  }
  return route;
}

std::string stops_yaml(const Passage& passage) {
  std::string text;
  for (const PassageStation& station : passage.stations())
    if (!station.stop.empty()) text += checkpoint_yaml(station.stop, mm * station.tip_W, sphere);
  return text;
}

}  // namespace fulcrum::content
