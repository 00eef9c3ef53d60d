#pragma once
// Which of a scene's objects a point of its surface belongs to. The objects are baked into one distance
// field, which does not tell; samples of each object's own surface do, to within their spacing.

#include <cstdint>
#include <span>
#include <vector>

#include "haptics/geometry/triangle_mesh.h"

namespace fulcrum {

class ObjectMap {
public:
  // samples_W (n x 3) m, at least one; objects (n): the number of the object that each lies on.
  ObjectMap(std::span<const Vec3> samples_W, std::span<const std::int32_t> objects);

  // The object of the nearest sample; of several equally near ones, of one of them, always the same.
  // Real-time: no allocation, no throw; a point that is not a number gets some object.
  std::int32_t nearest(const Vec3& p_W) const noexcept;

  std::size_t size() const { return samples_.size(); }
  std::size_t bytes() const;

private:
  struct Best {
    double squared;  // m^2
    std::size_t sample;
  };
  void search(std::size_t level, std::size_t node, const Vec3& p_W, Best& best) const noexcept;

  std::vector<Vec3> samples_;          // in kd order
  std::vector<std::int32_t> objects_;  // of each sample
  // Boxes of 16 samples each, then of 16 boxes each, up to one.
  std::vector<std::vector<Box3>> levels_;
};

}  // namespace fulcrum
