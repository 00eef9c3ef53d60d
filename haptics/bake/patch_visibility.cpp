#include "haptics/bake/patch_visibility.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "haptics/bake/triangle_tree.h"
#include "haptics/bake/weld.h"
#include "haptics/math/functions.h"

namespace fulcrum {
namespace {

constexpr std::size_t kPlaces = 64;      // of a patch
constexpr std::size_t kDirections = 32;  // of each place, half of them to either side
constexpr double kLift = 1e-6;           // of the body's diagonal, off the triangle a ray starts from

// Evenly over the sphere: a golden-angle spiral.
Vec3 direction(std::size_t i) {
  const double y = 1.0 - (2.0 * static_cast<double>(i) + 1.0) / kDirections;
  const double turn = std::numbers::pi * (3.0 - std::sqrt(5.0)) * static_cast<double>(i);
  return {std::sqrt(1.0 - y * y) * math::cos(turn), y, std::sqrt(1.0 - y * y) * math::sin(turn)};
}

// The bodies as components of something a tree can be built from; body[t]: which one a triangle belongs to.
Solid bodies_of(const TriangleMesh& mesh, std::vector<std::uint32_t>& body) {
  Sets sets(static_cast<std::size_t>(mesh.triangles.size()));
  EdgeFans(mesh.triangles).for_each([&sets](std::span<const HalfEdge> fan) {
    for (const HalfEdge& edge : fan) sets.join(fan[0].place / 3, edge.place / 3);
  });
  std::vector<std::uint32_t> order;
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) order.push_back(t);
  std::stable_sort(order.begin(), order.end(),
                   [&sets](std::uint32_t l, std::uint32_t r) { return sets.find(l) < sets.find(r); });
  Solid bodies;
  bodies.mesh.vertices = mesh.vertices;
  body.resize(mesh.triangles.size());
  for (std::size_t i = 0; i < order.size(); ++i) {
    if (i == 0 || sets.find(order[i]) != sets.find(order[i - 1])) {
      bodies.components.emplace_back();
      bodies.components.back().first_triangle = static_cast<std::uint32_t>(i);
    }
    SolidComponent& component = bodies.components.back();
    ++component.triangle_count;
    for (const std::uint32_t v : mesh.triangles[order[i]]) component.bounds.extend(mesh.vertices[v]);
    bodies.mesh.triangles.push_back(mesh.triangles[order[i]]);
    body[order[i]] = static_cast<std::uint32_t>(bodies.components.size() - 1);
  }
  return bodies;
}

class Observer {
public:
  explicit Observer(const TriangleMesh& mesh)
      : mesh_(mesh), bodies_(bodies_of(mesh, body_)), tree_(bodies_) {}

  // From places spread over the patch by area.
  PatchVisibility operator()(const Patch& patch) const {
    std::vector<double> upto;
    for (const std::uint32_t t : patch.triangles)
      upto.push_back((upto.empty() ? 0.0 : upto.back()) + cross(t).norm());
    if (!(upto.back() > 0.0)) return {};
    PatchVisibility seen;
    for (std::size_t i = 0; i < kPlaces; ++i) {
      const double area = (static_cast<double>(i) + 0.5) / kPlaces * upto.back();
      const auto found = std::upper_bound(upto.begin(), upto.end() - 1, area);
      look_from(patch.triangles[static_cast<std::size_t>(found - upto.begin())], seen);
    }
    return seen;
  }

private:
  Vec3 cross(std::uint32_t t) const {
    const Triangle& corner = mesh_.triangles[t];
    const Vec3& a = mesh_.vertices[corner[0]];
    return (mesh_.vertices[corner[1]] - a).cross(mesh_.vertices[corner[2]] - a);
  }

  void look_from(std::uint32_t t, PatchVisibility& seen) const {
    const Triangle& corner = mesh_.triangles[t];
    const Vec3 centroid =
        (mesh_.vertices[corner[0]] + mesh_.vertices[corner[1]] + mesh_.vertices[corner[2]]) / 3.0;
    const Vec3 n = cross(t).stableNormalized();
    const double across = bodies_.components[body_[t]].bounds.diagonal().norm();
    for (std::size_t i = 0; i < kDirections; ++i) {
      const Vec3 along = direction(i);
      const double side = along.dot(n) > 0.0 ? 1.0 : -1.0;
      const Vec3 from = centroid + side * kLift * across * n;
      if (tree_.first_hit(tree_.of_component(body_[t]), from, from + 2.0 * across * along)) continue;
      (side > 0.0 ? seen.front : seen.back) += 2.0 / (kPlaces * kDirections);
    }
  }

  const TriangleMesh& mesh_;
  std::vector<std::uint32_t> body_;  // (triangles)
  Solid bodies_;
  TriangleTree tree_;
};

}  // namespace

std::vector<PatchVisibility> measure_visibility(const TriangleMesh& mesh, const std::vector<Patch>& patches) {
  const Observer observer(mesh);
  std::vector<PatchVisibility> visibility;
  for (const Patch& patch : patches) {
    // A patch that is closed by itself needs nobody to tell its sides.
    visibility.push_back(patch.open || patch.joined ? observer(patch) : PatchVisibility{1.0, 0.0});
  }
  return visibility;
}

}  // namespace fulcrum
