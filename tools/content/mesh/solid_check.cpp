#include "tools/content/mesh/solid_check.h"

#include <algorithm>
#include <cstdio>
#include <map>
#include <tuple>

#include "tools/content/mesh/triangle_tree.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr double least_area = 1e-12;  // m^2

Solid as_written(const Solid& solid) {
  std::map<std::tuple<float, float, float>, std::uint32_t> welded;
  Solid result;
  std::vector<std::uint32_t> new_index;
  for (const Vector3d& p : solid.points) {
    const Eigen::Vector3f f = p.cast<float>();
    const auto [at, is_new] =
        welded.emplace(std::tuple(f.x(), f.y(), f.z()), static_cast<std::uint32_t>(result.points.size()));
    if (is_new) result.points.push_back(f.cast<double>());
    new_index.push_back(at->second);
  }
  for (const Triangle& t : solid.triangles)
    result.triangles.push_back({new_index[t[0]], new_index[t[1]], new_index[t[2]]});
  return result;
}

using Edge = std::pair<std::uint32_t, std::uint32_t>;

// Each directed edge once and its reverse once: closed, two triangles to an edge, wound alike.
bool edges_pair_up(const Solid& solid) {
  std::map<Edge, int> directed;
  for (const Triangle& t : solid.triangles)
    for (std::size_t k = 0; k < 3; ++k) ++directed[{t[k], t[(k + 1) % 3]}];
  return std::all_of(directed.begin(), directed.end(), [&](const auto& entry) {
    const auto reverse = directed.find({entry.first.second, entry.first.first});
    return entry.second == 1 && reverse != directed.end();
  });
}

// The triangles around each point form one fan.
bool fans_are_single(const Solid& solid) {
  std::vector<std::map<std::uint32_t, std::uint32_t>> next_around(solid.points.size());
  for (const Triangle& t : solid.triangles)
    for (std::size_t k = 0; k < 3; ++k) next_around[t[k]][t[(k + 1) % 3]] = t[(k + 2) % 3];
  for (const auto& around : next_around) {
    if (around.empty()) continue;
    const std::uint32_t start = around.begin()->first;
    std::uint32_t at = start;
    std::size_t steps = 0;
    do {
      at = around.at(at);
      ++steps;
    } while (at != start && steps <= around.size());
    if (steps != around.size()) return false;
  }
  return true;
}

bool crosses(const Vector3d& from, const Vector3d& to, const Vector3d& a, const Vector3d& b,
             const Vector3d& c) {
  const Vector3d normal = (b - a).cross(c - a);
  const double d_from = normal.dot(from - a);
  const double d_to = normal.dot(to - a);
  if (d_from * d_to >= 0.0) return false;
  const Vector3d p = from + d_from / (d_from - d_to) * (to - from);
  return normal.dot((b - a).cross(p - a)) > 0.0 && normal.dot((c - b).cross(p - b)) > 0.0 &&
         normal.dot((a - c).cross(p - c)) > 0.0;
}

bool self_intersects(const Solid& solid) {
  TriangleTree tree;
  tree.add(solid);
  tree.build();
  for (const Triangle& t : solid.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = t[k];
      const std::uint32_t to = t[(k + 1) % 3];
      if (from > to) continue;  // the neighbour has the same edge
      Eigen::AlignedBox3d box(solid.points[from]);
      box.extend(solid.points[to]);
      for (const std::uint32_t other : tree.touching(box)) {
        const Triangle& o = solid.triangles[other];
        const bool shares = std::any_of(o.begin(), o.end(), [&](auto v) { return v == from || v == to; });
        if (!shares && crosses(solid.points[from], solid.points[to], solid.points[o[0]], solid.points[o[1]],
                               solid.points[o[2]]))
          return true;
      }
    }
  }
  return false;
}

double area(const Solid& solid, const Triangle& t) {
  const Vector3d& a = solid.points[t[0]];
  return 0.5 * (solid.points[t[1]] - a).cross(solid.points[t[2]] - a).norm();
}

}  // namespace

std::string what_is_wrong(const Solid& solid) {
  const Solid written = as_written(solid);
  if (written.triangles.empty()) return "it has no triangles";
  for (const Triangle& t : written.triangles)
    if (area(written, t) <= least_area) return "a triangle is degenerate";
  if (!edges_pair_up(written)) return "an edge is not shared by exactly two triangles wound alike";
  if (!fans_are_single(written)) return "surfaces touch in a single point";
  if (signed_volume(written) <= 0.0) return "it faces inwards";
  if (self_intersects(written)) return "it intersects itself";
  return {};
}

bool check_solids(const Model& model) {
  bool sound = true;
  for (const Part& part : model.parts) {
    const std::string trouble = what_is_wrong(part.solid);
    if (trouble.empty()) continue;
    sound = false;
    std::printf("%s: %s\n", part.name.c_str(), trouble.c_str());
  }
  std::printf("%s: %zu parts, %s\n", model.name.c_str(), model.parts.size(),
              sound ? "all sound" : "NOT SOUND");
  return sound;
}

}  // namespace fulcrum::content
