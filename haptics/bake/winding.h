#pragma once
// How often a closed surface winds around a point: 0 outside, 1 inside, 2 where it overlaps itself, -1 where
// it is inside out. A. Jacobson, L. Kavan, O. Sorkine-Hornung, "Robust inside-outside segmentation using
// generalized winding numbers" (SIGGRAPH 2013); far triangles together as a dipole, after G. Barill, N. G.
// Dickson, R. Schmidt, D. I. W. Levin, A. Jacobson, "Fast winding numbers for soups and clouds" (SIGGRAPH
// 2018). Here the surface is closed: the number is whole, and knowing it to within a half is knowing it.

#include <cstdint>
#include <span>
#include <vector>

#include "haptics/geometry/triangle_mesh.h"

namespace fulcrum {

class Winding {
public:
  explicit Winding(const TriangleMesh& closed);

  // Const and safe to call from several threads at once. On the surface it is one of the numbers beside it.
  int around(const Vec3& p) const;

private:
  struct Corners {
    Vec3 a, b, c;
  };
  struct Node {
    Vec3 centre = Vec3::Zero();          // (3) m, of its triangles by area
    Vec3 dipole = Vec3::Zero();          // (3) m^2, the sum of their areas times normals
    double radius = 0.0;                 // m, none of their corners is farther from the centre
    std::uint32_t first = 0, count = 0;  // of corners_
    std::uint32_t child = 0;             // of two, one after the other; 0: a leaf
  };
  void build(std::uint32_t index);
  double sum(const Vec3& p, double far) const;

  std::vector<Corners> corners_;
  std::vector<Node> nodes_;
};

}  // namespace fulcrum
