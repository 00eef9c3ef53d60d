#pragma once
// All directions within an angle of an axis: what a feature's normals lie in.

#include <span>

#include "haptics/math/linear.h"

namespace fulcrum {

class NormalCone {
public:
  NormalCone() = default;                // none
  explicit NormalCone(const Vec3& axis)  // one direction
      : axis_(axis), angle_(0), cosine_(1) {}
  NormalCone(const Vec3& axis, double angle);

  // A cone that holds all of these unit vectors, or all of two cones; a narrow one, not the narrowest.
  static NormalCone about(std::span<const Vec3> directions);
  static NormalCone about(const NormalCone& a, const NormalCone& b);

  bool none() const { return angle_ < 0; }
  const Vec3& axis() const { return axis_; }  // (3) unit
  double angle() const { return angle_; }     // rad, between the axis and what lies farthest from it
  double cosine() const { return cosine_; }   // of it
  double sine() const { return sine_; }

  // Whether one of these directions, and one of the other's, are opposite but for `slack`'s angle. axis: this
  // cone's, in the other's frame.
  bool opposes(const Vec3& axis, const NormalCone& other, const NormalCone& slack) const noexcept;

private:
  Vec3 axis_ = Vec3::Zero();
  double angle_ = -1, cosine_ = 0, sine_ = 0;
};

}  // namespace fulcrum
