#pragma once
// How far a vertex would be from the triangles that it is to stand for: in place, and in what is seen of
// them.

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/glm.hpp>

namespace fulcrum::render {

inline constexpr std::size_t kSeen = 6;  // normal and colour
using SeenAt = std::array<double, kSeen>;

// x -> x'Ax + 2 b'x + c, of a plane the squared distance times a weight.
struct PlaneQuadric {
  std::array<double, 6> a{};  // xx yy zz xy xz yz
  glm::dvec3 b{0.0};
  double c = 0.0;

  // weight (n.x + d)^2
  void add_plane(const glm::dvec3& n, double d, double weight) {
    a[0] += weight * n.x * n.x;
    a[1] += weight * n.y * n.y;
    a[2] += weight * n.z * n.z;
    a[3] += weight * n.x * n.y;
    a[4] += weight * n.x * n.z;
    a[5] += weight * n.y * n.z;
    b += weight * d * n;
    c += weight * d * d;
  }

  void add(const PlaneQuadric& other) {
    for (std::size_t i = 0; i < a.size(); ++i) a[i] += other.a[i];
    b += other.b;
    c += other.c;
  }

  double at(const glm::dvec3& x) const {
    return a[0] * x.x * x.x + a[1] * x.y * x.y + a[2] * x.z * x.z +
           2.0 * (a[3] * x.x * x.y + a[4] * x.x * x.z + a[5] * x.y * x.z + glm::dot(b, x)) + c;
  }
};

// Of the triangles round a vertex, and of those that it has taken over.
class VertexQuadric {
public:
  // p: corners (m), seen: what is seen at each, in units of a large difference.
  void add_triangle(const std::array<glm::dvec3, 3>& p, const std::array<SeenAt, 3>& seen) {
    const glm::dvec3 e1 = p[1] - p[0], e2 = p[2] - p[0], across = glm::cross(e1, e2);
    const double twice_area = glm::length(across);
    if (!(twice_area > 0.0)) return;
    const glm::dvec3 n = across / twice_area;
    const double area = 0.5 * twice_area;
    area_ += area;
    place_.add_plane(n, -glm::dot(n, p[0]), area);
    // Within the triangle all of it is linear: its gradients, and what it is at the origin.
    const glm::dvec3 g1 = glm::cross(e2, n) / twice_area, g2 = glm::cross(n, e1) / twice_area;
    for (std::size_t k = 0; k < kSeen; ++k) {
      const glm::dvec3 g = (seen[1][k] - seen[0][k]) * g1 + (seen[2][k] - seen[0][k]) * g2;
      const double d = seen[0][k] - glm::dot(g, p[0]);
      seen_.add_plane(g, d, area);
      gradient_[k] += area * g;
      offset_[k] += area * d;
    }
  }

  // The plane through a triangle's first edge that stands upright on it, with the weight of the triangle.
  void add_upright(const std::array<glm::dvec3, 3>& p) {
    const glm::dvec3 edge = p[1] - p[0], across = glm::cross(edge, p[2] - p[0]),
                     out = glm::cross(edge, across);
    const double length = glm::length(out);
    if (!(length > 0.0)) return;
    place_.add_plane(out / length, -glm::dot(out / length, p[0]), 0.5 * glm::length(across));
  }

  void add(const VertexQuadric& other) {
    area_ += other.area_;
    place_.add(other.place_);
    seen_.add(other.seen_);
    for (std::size_t k = 0; k < kSeen; ++k) {
      gradient_[k] += other.gradient_[k];
      offset_[k] += other.offset_[k];
    }
  }

  // m^2: the mean squared distance from the planes, and the squared differences over their area.
  double error(const glm::dvec3& p, const SeenAt& seen) const {
    if (!(area_ > 0.0)) return 0.0;
    double differences = seen_.at(p);
    for (std::size_t k = 0; k < kSeen; ++k)
      differences += seen[k] * (area_ * seen[k] - 2.0 * (glm::dot(gradient_[k], p) + offset_[k]));
    return std::max(0.0, place_.at(p)) / area_ + std::max(0.0, differences);
  }

private:
  double area_ = 0.0;  // m^2
  PlaneQuadric place_, seen_;
  std::array<glm::dvec3, kSeen> gradient_{};
  std::array<double, kSeen> offset_{};
};

}  // namespace fulcrum::render
