#pragma once
// Flat shapes, and the solids that they become when they are extruded.

#include <array>
#include <cstdint>
#include <vector>

#include "haptics/geometry/triangle_mesh.h"

namespace fulcrum::parts {

using Vec2 = Eigen::Vector2d;

struct Flat {
  std::vector<Vec2> points;         // (n x 2) m
  std::vector<Triangle> triangles;  // (m x 3) counter-clockwise, edge to edge
};

// A closed outline, counter-clockwise, of which all is seen from `middle`.
Flat star(const std::vector<Vec2>& outline, const Vec2& middle = Vec2::Zero());
// Between two closed outlines of as many points, of which each pair lies on one ray from the middle.
Flat ring(const std::vector<Vec2>& inner, const std::vector<Vec2>& outer);
// Columns side by side: column i reaches from x[i] to x[i + 1], and from low[i] to high[i]. Where neighbours
// differ their common edge is cut, so that triangles lie edge to edge.
Flat columns(const std::vector<double>& x, const std::vector<double>& low, const std::vector<double>& high);

// From z = low to high, along z.
TriangleMesh extruded(const Flat& flat, double low, double high);

// n points of a circle about the origin, the first at `from_rad`.
std::vector<Vec2> circle(double radius, int n, double from_rad = 0);

TriangleMesh moved(TriangleMesh mesh, const Eigen::Isometry3d& X);
void append(TriangleMesh& to, const TriangleMesh& more);

}  // namespace fulcrum::parts
