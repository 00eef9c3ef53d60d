#pragma once
// Where features lie and where their normals point, in single precision, four side by side: rounded so that
// each holds what it stands for.

#include <array>
#include <cstdint>

#include "haptics/geometry/normal_cone.h"
#include "haptics/geometry/triangle_mesh.h"

namespace fulcrum {

// From one pose to another, straight and turning evenly, and around all of the way between.
struct Sweep {
  Mat3 R_from = Mat3::Identity(), R_middle = Mat3::Identity(), R_to = Mat3::Identity();
  Vec3 p_from = Vec3::Zero(), p_to = Vec3::Zero();  // (3) m
  double reach = 0;                                 // m, around
  double turn = 0;                                  // rad, likewise, about the frame's origin
  NormalCone slack;                                 // its angle: what normals are off from the middle's
};

// A box, and a cone about an axis.
struct Bounds {
  std::array<float, 3> low{}, high{};  // (3) m
  std::array<float, 3> axis{};         // (3) unit
  float cosine = -1, sine = 0;         // of the cone's angle

  static Bounds of(const Box3& box, const NormalCone& cone);
  float size() const { return high[0] - low[0] + (high[1] - low[1]) + (high[2] - low[2]); }  // m
};

class alignas(16) Bounds4 {
public:
  Bounds4();  // nothing meets them
  void set(unsigned lane, const Bounds& bounds);
  Bounds operator[](unsigned lane) const;
  float size(unsigned lane) const;  // m, as of Bounds

  // Boxes that hold all that is in these on the sweep's way or around; cones of the middle, and wider.
  Bounds4 swept(const Sweep& sweep) const noexcept;
  // Bit i: the box of `one` and that of lane i overlap.
  unsigned overlapping(const Bounds& one) const noexcept;
  // Bit 4 j + i: the boxes of the others' lane j and of lane i overlap, and some direction of the one's cone
  // is opposite to one of the other's.
  unsigned meeting(const Bounds4& others) const noexcept;

private:
  using Lanes = std::array<float, 4>;
  std::array<Lanes, 3> low_, high_, axis_;
  Lanes cosine_, sine_;
};

}  // namespace fulcrum
