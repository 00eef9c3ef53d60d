#include "haptics/geometry/object_map.h"

#include <algorithm>
#include <limits>

#include "haptics/geometry/kd_order.h"

namespace fulcrum {
namespace {

constexpr std::size_t kCellRun = 16;

}  // namespace

ObjectMap::ObjectMap(std::span<const Vec3> samples_W, std::span<const std::int32_t> objects) {
  for (const std::uint32_t i : kd_order(samples_W)) {
    samples_.push_back(samples_W[i]);
    objects_.push_back(objects[i]);
  }
  std::vector<Box3>& runs = levels_.emplace_back((samples_.size() + kCellRun - 1) / kCellRun);
  for (std::size_t i = 0; i < samples_.size(); ++i) runs[i / kCellRun].extend(samples_[i]);
  while (levels_.back().size() > 1) {
    const std::vector<Box3>& below = levels_.back();
    std::vector<Box3> level((below.size() + kCellRun - 1) / kCellRun);
    for (std::size_t i = 0; i < below.size(); ++i) level[i / kCellRun].extend(below[i]);
    levels_.push_back(std::move(level));
  }
}

std::int32_t ObjectMap::nearest(const Vec3& p_W) const noexcept {
  Best best{std::numeric_limits<double>::infinity(), 0};
  search(levels_.size() - 1, 0, p_W, best);
  return objects_[best.sample];
}

void ObjectMap::search(std::size_t level, std::size_t node, const Vec3& p_W, Best& best) const noexcept {
  const std::size_t first = node * kCellRun;
  if (level == 0) {
    for (std::size_t i = first; i < std::min(first + kCellRun, samples_.size()); ++i) {
      const double squared = (samples_[i] - p_W).squaredNorm();
      if (squared < best.squared) best = {squared, i};
    }
    return;
  }
  // The nearest first: the others are then mostly too far.
  const std::vector<Box3>& boxes = levels_[level - 1];
  const std::size_t end = std::min(first + kCellRun, boxes.size());
  std::size_t nearest = first;
  for (std::size_t i = first + 1; i < end; ++i)
    if (boxes[i].squaredExteriorDistance(p_W) < boxes[nearest].squaredExteriorDistance(p_W)) nearest = i;
  search(level - 1, nearest, p_W, best);
  for (std::size_t i = first; i < end; ++i)
    if (i != nearest && boxes[i].squaredExteriorDistance(p_W) < best.squared) search(level - 1, i, p_W, best);
}

std::size_t ObjectMap::bytes() const {
  std::size_t boxes = 0;
  for (const std::vector<Box3>& level : levels_) boxes += level.size();
  return samples_.size() * (sizeof(Vec3) + sizeof(std::int32_t)) + boxes * sizeof(Box3);
}

}  // namespace fulcrum
