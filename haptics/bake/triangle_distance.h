#pragma once
// The exact signed distance to a solid's triangles: the reference the distance field is made from and judged
// by.
//
// Sign: the angle-weighted pseudonormal of the closest feature, per component; J. A. Baerentzen and H.
// Aanaes, "Signed distance computation using the angle weighted pseudonormal" (IEEE TVCG 11(3), 2005); of a
// component with a shell, the winding number, unless the closest point lies in a triangle. Union: the minimum
// over the components. Outside that is the distance to the union. Inside it is minus the depth in the
// component in which the point lies deepest: at most the depth in the union, never more.

#include <cstdint>
#include <optional>
#include <vector>

#include "haptics/bake/containment.h"
#include "haptics/bake/solid.h"
#include "haptics/bake/triangle_tree.h"
#include "haptics/bake/winding.h"

namespace fulcrum {

struct ClosestPoint {
  double distance = 0.0;        // m, signed
  Vec3 point = Vec3::Zero();    // (3) m, on the surface
  Vec3 normal = Vec3::UnitY();  // (3) unit, outward there: the pseudonormal, or the way out to p
  std::uint32_t triangle = 0;   // into Solid::mesh.triangles
};

struct Crossing {
  std::uint32_t triangle = 0;  // into Solid::mesh.triangles
  double fraction = 0.0;       // of the way from p0 to p1
  bool entering = false;       // from the outer side of the triangle to the inner one
};

// Const and safe to call from several threads at once.
class TriangleDistance {
public:
  explicit TriangleDistance(const Solid& solid);

  double signed_distance(const Vec3& p) const;
  // min(signed_distance(p), r), faster: parts farther than r away are not looked at. Inside it is exact.
  double signed_distance_within(const Vec3& p, double r) const;
  ClosestPoint closest(const Vec3& p) const;

  // The first triangle met on the way from p0 to p1; edges and vertices belong to every triangle they bound,
  // so that no path slips between two of them. Segments that lie in a triangle's plane do not cross it.
  std::optional<Crossing> first_crossing(const Vec3& p0, const Vec3& p1) const;

  // One component alone. `hint` is a triangle of it to try first (Solid::mesh order), and becomes the closest
  // one: neighbouring points cost less. The answer does not depend on it.
  double component_distance(std::uint32_t component, const Vec3& p, std::uint32_t& hint) const;
  Vec3 closest_on(std::uint32_t triangle, const Vec3& p) const { return tree_.closest_on(triangle, p); }
  std::optional<Crossing> first_crossing_of(std::uint32_t component, const Vec3& p0, const Vec3& p1) const;
  const TriangleTree& tree() const { return tree_; }

private:
  enum class Trust : unsigned char { always, face, never };  // face: not in those of its edges and corners

  bool is_inside(std::uint32_t component, const Vec3& p, const TriangleTree::Nearest& nearest) const;
  // Whether the closest feature's normal tells inside from outside there.
  bool has_normal(const TriangleTree::Nearest& nearest) const;
  Vec3 pseudonormal(std::uint32_t triangle, TriangleFeature feature) const;
  ClosestPoint closest_below(const Vec3& p, double limit) const;
  std::optional<Crossing> crossing(TriangleTree::Root root, const Vec3& p0, const Vec3& p1) const;

  TriangleTree tree_;
  std::vector<Triangle> triangles_;               // (m x 3)
  std::vector<Triangle> neighbours_;              // (m x 3) across edge e
  std::vector<Vec3> face_normals_;                // (m x 3) unit; zero for a triangle without area
  std::vector<Vec3> vertex_normals_;              // (n x 3) unit, angle-weighted
  std::vector<Trust> trust_;                      // (m) in the triangle's normals
  std::vector<std::optional<Winding>> windings_;  // (components) of those with a shell
  std::optional<Containment> containment_;
};

}  // namespace fulcrum
