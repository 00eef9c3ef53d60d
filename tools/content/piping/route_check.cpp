#include "tools/content/piping/route_check.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "haptics/math/rotation.h"
#include "tools/content/mesh/triangle_tree.h"
#include "tools/content/piping/piping.h"
#include "tools/content/piping/route.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr double line_step = 2.0 * mm;
constexpr double turn_step = 1.0 * degree;
constexpr double farthest = 0.05;  // m: nobody asks for clearances beyond

bool is_asked_for(const std::string& name, Near near) {
  switch (near) {
    case Near::slot_pipes:
      return is_slot_pipe(name);
    case Near::target_bolt:
      return is_target_bolt(name);
    case Near::everything_else:
      return !is_slot_pipe(name) && !is_target_bolt(name);
  }
  return false;
}

// Points on every edge, no further apart than the spacing, ends included.
std::vector<Vector3d> edge_points(const Solid& solid, double spacing) {
  std::vector<Vector3d> points = solid.points;
  for (const Triangle& t : solid.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (t[k] > t[(k + 1) % 3]) continue;
      const Vector3d& a = solid.points[t[k]];
      const Vector3d& b = solid.points[t[(k + 1) % 3]];
      const int pieces = std::max(2, static_cast<int>(std::ceil((b - a).norm() / spacing)));
      for (int i = 1; i < pieces; ++i) points.push_back(a + (b - a) * i / pieces);
    }
  }
  return points;
}

int steps_between(const Eigen::Isometry3d& from, const Eigen::Isometry3d& to) {
  const double line = (to.translation() - from.translation()).norm();
  const double turn = angle_of(Eigen::Quaterniond(from.linear().transpose() * to.linear()));
  return std::max(1, static_cast<int>(std::ceil(std::max(line / line_step, turn / turn_step))));
}

// "07" of "flange/07/a"; empty for what belongs to no line, or stands on the frame.
std::string line_of(const std::string& name) {
  for (const char* kind : {"pipe/", "flange/", "blind_flange/", "gasket/", "bolt/", "nut/", "washer/",
                           "valve/", "hand_wheel/", "gauge/"})
    if (name.starts_with(kind)) return name.substr(std::string(kind).size(), 2);
  return {};
}

struct LineParts {
  std::vector<const Part*> parts;
  TriangleTree tree;
  Eigen::AlignedBox3d box;
};

}  // namespace

std::vector<Clearance> clearances(const Model& piping, const Model& spanner, Near near) {
  TriangleTree tree;
  for (const Part& part : piping.parts)
    if (is_asked_for(part.name, near)) tree.add(part.solid);
  tree.build();
  const std::vector<Vector3d> points_T = edge_points(spanner.parts.front().solid, 1.0);
  const std::vector<PlantPose> poses = route();
  std::vector<Clearance> result;
  for (std::size_t i = 0; i + 1 < poses.size(); ++i) {
    Clearance nearest{farthest, 0.0, i, Vector3d::Zero()};
    const int steps = steps_between(poses[i].X_WT, poses[i + 1].X_WT);
    for (int k = 0; k <= steps; ++k) {
      const double u = static_cast<double>(k) / steps;
      const Eigen::Isometry3d X_WT = between(poses[i].X_WT, poses[i + 1].X_WT, u);
      for (const Vector3d& p_T : points_T) {
        const Vector3d p_W = X_WT * p_T;
        const double distance = tree.distance(p_W, nearest.distance);
        if (distance < nearest.distance) nearest = {distance, u, i, p_W};
      }
    }
    result.push_back(nearest);
  }
  return result;
}

LineGap narrowest_line_gap(const Model& piping) {
  std::map<std::string, LineParts> lines;
  for (const Part& part : piping.parts) {
    const std::string line = line_of(part.name);
    if (line.empty()) continue;
    lines[line].parts.push_back(&part);
    lines[line].tree.add(part.solid);
    for (const Vector3d& p : part.solid.points) lines[line].box.extend(p);
  }
  for (auto& [name, line] : lines) line.tree.build();

  // Pipes' edges are long: points along them stand for what lies between their ends.
  constexpr double spacing = 4.0 * mm;
  LineGap narrowest{farthest, "", ""};
  for (const auto& [name, line] : lines) {
    for (const Part* part : line.parts) {
      for (const Vector3d& p : edge_points(part->solid, spacing)) {
        for (const auto& [other_name, other] : lines) {
          if (other_name == name || other.box.exteriorDistance(p) >= narrowest.distance) continue;
          const double distance = other.tree.distance(p, narrowest.distance);
          if (distance < narrowest.distance) narrowest = {distance, part->name, "line " + other_name};
        }
      }
    }
  }
  return narrowest;
}

}  // namespace fulcrum::content
