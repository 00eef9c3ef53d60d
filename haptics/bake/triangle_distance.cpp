#include "haptics/bake/triangle_distance.h"

#include <cmath>
#include <limits>

#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

constexpr double kEverything = std::numeric_limits<double>::infinity();

Vec3 unit_or_zero(const Vec3& v) {
  const double length = v.norm();
  return length > 0.0 ? Vec3(v / length) : Vec3(Vec3::Zero());
}

}  // namespace

TriangleDistance::TriangleDistance(const Solid& solid)
    : tree_(solid),
      triangles_(solid.mesh.triangles),
      neighbours_(solid.neighbours),
      face_normals_(solid.mesh.triangles.size()),
      vertex_normals_(solid.mesh.vertices.size(), Vec3::Zero()),
      trust_(solid.mesh.triangles.size(), Trust::always) {
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    const Triangle& corner = triangles_[t];
    const auto at = [&](std::size_t i) { return solid.mesh.vertices[corner[i % 3]]; };
    face_normals_[t] = unit_or_zero((at(1) - at(0)).cross(at(2) - at(0)));
    for (std::size_t i = 0; i < 3; ++i)
      vertex_normals_[corner[i]] += face_normals_[t] * angle_between(at(i + 1) - at(i), at(i + 2) - at(i));
  }
  for (Vec3& normal : vertex_normals_) normal = unit_or_zero(normal);

  std::vector<Containment::Candidate> all;
  for (const SolidComponent& component : solid.components) {
    all.push_back({static_cast<std::uint32_t>(all.size()), component.first_triangle});
    if (component.shell.triangles.empty()) {
      windings_.emplace_back();
      continue;
    }
    windings_.emplace_back(component.shell);
    for (std::uint32_t t = component.first_triangle; t < component.first_triangle + component.triangle_count;
         ++t) {
      const Triangle& corner = triangles_[t];
      const bool thin = is_sliver(solid.mesh.vertices[corner[0]], solid.mesh.vertices[corner[1]],
                                  solid.mesh.vertices[corner[2]]);
      trust_[t] = thin ? Trust::never : Trust::face;
    }
  }
  containment_.emplace(solid.bounds(), all,
                       [this](std::uint32_t component, const Vec3& p, std::uint32_t& hint) {
                         return component_distance(component, p, hint);
                       });
}

Vec3 TriangleDistance::pseudonormal(std::uint32_t triangle, TriangleFeature feature) const {
  switch (feature) {
    case TriangleFeature::face:
      return face_normals_[triangle];
    case TriangleFeature::edge0:
    case TriangleFeature::edge1:
    case TriangleFeature::edge2: {
      const auto edge = static_cast<std::size_t>(feature) - static_cast<std::size_t>(TriangleFeature::edge0);
      const std::uint32_t there = neighbours_[triangle][edge];
      if (there == Solid::kNoNeighbour) return face_normals_[triangle];
      return unit_or_zero(face_normals_[triangle] + face_normals_[there]);
    }
    case TriangleFeature::corner0:
    case TriangleFeature::corner1:
    case TriangleFeature::corner2: {
      const auto corner =
          static_cast<std::size_t>(feature) - static_cast<std::size_t>(TriangleFeature::corner0);
      return vertex_normals_[triangles_[triangle][corner]];
    }
  }
  return Vec3::Zero();
}

bool TriangleDistance::has_normal(const TriangleTree::Nearest& nearest) const {
  const Trust trust = trust_[nearest.triangle];
  return trust == Trust::always || (trust == Trust::face && nearest.feature == TriangleFeature::face);
}

bool TriangleDistance::is_inside(std::uint32_t component, const Vec3& p,
                                 const TriangleTree::Nearest& nearest) const {
  if (!has_normal(nearest)) return windings_[component]->around(p) > 0;
  return (p - nearest.point).dot(pseudonormal(nearest.triangle, nearest.feature)) < 0.0;
}

double TriangleDistance::component_distance(std::uint32_t component, const Vec3& p,
                                            std::uint32_t& hint) const {
  const TriangleTree::Nearest nearest = tree_.nearest(tree_.of_component(component), p, kEverything, hint);
  if (nearest.triangle == TriangleTree::kNone) return kEverything;  // p is not a number
  hint = nearest.triangle;
  return is_inside(component, p, nearest) ? -std::sqrt(nearest.squared) : std::sqrt(nearest.squared);
}

// Components that may hold p are asked in full. Of all others p is outside, and the closest triangle of all
// decides.
ClosestPoint TriangleDistance::closest_below(const Vec3& p, double limit) const {
  ClosestPoint best;
  best.distance = limit;
  TriangleTree::Nearest nearest;
  const auto take = [&](double distance) {
    best = {distance, nearest.point, pseudonormal(nearest.triangle, nearest.feature), nearest.triangle};
    if (distance != 0.0 && !has_normal(nearest)) best.normal = (p - nearest.point) / distance;
  };
  for (const auto& [component, hint] : containment_->candidates(p)) {
    nearest = tree_.nearest(tree_.of_component(component), p, kEverything, hint);
    const double distance =
        is_inside(component, p, nearest) ? -std::sqrt(nearest.squared) : std::sqrt(nearest.squared);
    if (distance < best.distance) take(distance);
  }
  if (best.distance > 0.0) {
    nearest = tree_.nearest(tree_.whole(), p, best.distance * best.distance, TriangleTree::kNone);
    if (nearest.triangle != TriangleTree::kNone) take(std::sqrt(nearest.squared));
  }
  return best;
}

double TriangleDistance::signed_distance(const Vec3& p) const {
  return closest(p).distance;
}

double TriangleDistance::signed_distance_within(const Vec3& p, double r) const {
  return closest_below(p, r).distance;
}

ClosestPoint TriangleDistance::closest(const Vec3& p) const {
  return closest_below(p, kEverything);
}

std::optional<Crossing> TriangleDistance::crossing(TriangleTree::Root root, const Vec3& p0,
                                                   const Vec3& p1) const {
  const std::optional<TriangleTree::Hit> hit = tree_.first_hit(root, p0, p1);
  if (!hit) return std::nullopt;
  return Crossing{hit->triangle, hit->fraction, (p1 - p0).dot(face_normals_[hit->triangle]) < 0.0};
}

std::optional<Crossing> TriangleDistance::first_crossing(const Vec3& p0, const Vec3& p1) const {
  return crossing(tree_.whole(), p0, p1);
}

std::optional<Crossing> TriangleDistance::first_crossing_of(std::uint32_t component, const Vec3& p0,
                                                            const Vec3& p1) const {
  return crossing(tree_.of_component(component), p0, p1);
}

}  // namespace fulcrum
