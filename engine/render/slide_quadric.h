#pragma once
// How far textures would slide over the surface if a vertex took the place of the triangles round it.

#include <algorithm>
#include <array>
#include <cstddef>
#include <glm/glm.hpp>

#include "engine/render/quadric.h"

namespace fulcrum::render {

inline constexpr std::size_t kUv = 4;  // two sets of two
using UvAt = std::array<double, kUv>;

// Of the triangles round a vertex, and of those that it has taken over, as VertexQuadric is. Within a
// triangle a coordinate is constant along lines: a vertex that has another value than belongs to its place
// moves the line through it, by the difference over the coordinate's gradient.
class SlideQuadric {
public:
  // p: corners (m), uv: at each, of a gradient about 1 (1/m) where a texture is neither stretched nor
  // pressed.
  void add_triangle(const std::array<glm::dvec3, 3>& p, const std::array<UvAt, 3>& uv) {
    const glm::dvec3 e1 = p[1] - p[0], e2 = p[2] - p[0], across = glm::cross(e1, e2);
    const double twice_area = glm::length(across);
    if (!(twice_area > 0.0)) return;
    const glm::dvec3 n = across / twice_area;
    const double area = 0.5 * twice_area;
    area_ += area;
    const glm::dvec3 g1 = glm::cross(e2, n) / twice_area, g2 = glm::cross(n, e1) / twice_area;
    for (std::size_t k = 0; k < kUv; ++k) {
      const glm::dvec3 g = (uv[1][k] - uv[0][k]) * g1 + (uv[2][k] - uv[0][k]) * g2;
      const double d = uv[0][k] - glm::dot(g, p[0]);
      const double weight = area / std::max(glm::dot(g, g), kLeastGradient * kLeastGradient);
      squares_.add_plane(g, d, weight);
      weight_[k] += weight;
      gradient_[k] += weight * g;
      offset_[k] += weight * d;
    }
  }

  void add(const SlideQuadric& other) {
    area_ += other.area_;
    squares_.add(other.squares_);
    for (std::size_t k = 0; k < kUv; ++k) {
      weight_[k] += other.weight_[k];
      gradient_[k] += other.gradient_[k];
      offset_[k] += other.offset_[k];
    }
  }

  // m^2, in the mean.
  double error(const glm::dvec3& p, const UvAt& uv) const {
    if (!(area_ > 0.0)) return 0.0;
    double squares = squares_.at(p);
    for (std::size_t k = 0; k < kUv; ++k)
      squares += uv[k] * (weight_[k] * uv[k] - 2.0 * (glm::dot(gradient_[k], p) + offset_[k]));
    return std::max(0.0, squares) / area_;
  }

private:
  // What is stretched eight times or more is taken as stretched so: where a texture hardly changes, any
  // change would slide it to infinity.
  static constexpr double kLeastGradient = 0.125;

  double area_ = 0.0;  // m^2
  PlaneQuadric squares_;
  std::array<double, kUv> weight_{};
  std::array<glm::dvec3, kUv> gradient_{};
  std::array<double, kUv> offset_{};
};

}  // namespace fulcrum::render
