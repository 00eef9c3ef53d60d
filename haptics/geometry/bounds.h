#pragma once
// Where features lie and where their normals point, in single precision, four side by side: rounded so that
// each holds what it stands for.

#include <array>
#include <cstdint>

#include "haptics/geometry/normal_cone.h"
#include "haptics/geometry/triangle_mesh.h"

namespace fulcrum {

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

  // Boxes that hold all that is nearer than `reach` m to these once they are turned and moved; cones turned,
  // and wider by `slack`'s angle.
  Bounds4 moved(const Mat3& R, const Vec3& p, double reach, const NormalCone& slack) const noexcept;
  // Bit i: the box of `one` and that of lane i overlap, and some direction of its cone is opposite to one of
  // lane i's.
  unsigned meeting(const Bounds& one) const noexcept;
  unsigned overlapping(const Bounds& one) const noexcept;  // the same of the boxes alone

private:
  using Lanes = std::array<float, 4>;
  std::array<Lanes, 3> low_, high_, axis_;
  Lanes cosine_, sine_;
};

}  // namespace fulcrum
