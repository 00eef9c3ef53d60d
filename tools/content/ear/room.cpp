#include "tools/content/ear/room.h"

#include <algorithm>
#include <cstddef>

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr double room_cell = 0.4;  // mm
constexpr double free_room = 9.0;  // mm
const Vector3d low(-30.0, -22.0, -29.0);
const Vector3d high(22.0, 26.0, 24.0);

std::size_t count(int axis) {
  return static_cast<std::size_t>((high[axis] - low[axis]) / room_cell) + 1;
}

}  // namespace

Room::Room(const Flesh& flesh) {
  for (std::size_t k = 0; k < count(2); ++k) {
    for (std::size_t j = 0; j < count(1); ++j) {
      for (std::size_t i = 0; i < count(0); ++i) {
        const Vector3d at(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
        const Vector3d p = low + room_cell * at;
        values_.push_back(
            static_cast<float>(std::min(flesh.distance(p), flesh.to_membrane(p, Flesh::buried_rim))));
      }
    }
  }
}

double Room::at(const Vector3d& p_W) const {
  const Vector3d u = (p_W - low) / room_cell;
  for (int axis = 0; axis < 3; ++axis)
    if (u[axis] < 0.0 || u[axis] >= static_cast<double>(count(axis) - 1)) return free_room;
  const auto i = static_cast<std::size_t>(u.x());
  const auto j = static_cast<std::size_t>(u.y());
  const auto k = static_cast<std::size_t>(u.z());
  const Vector3d t = u - Vector3d(static_cast<double>(i), static_cast<double>(j), static_cast<double>(k));
  const std::size_t row = count(0);
  const std::size_t layer = row * count(1);
  const float* v = &values_[k * layer + j * row + i];
  const auto line = [&](const float* a) {
    return (1.0 - t.x()) * static_cast<double>(a[0]) + t.x() * static_cast<double>(a[1]);
  };
  const double below = (1.0 - t.y()) * line(v) + t.y() * line(v + row);
  const double above = (1.0 - t.y()) * line(v + layer) + t.y() * line(v + layer + row);
  return (1.0 - t.z()) * below + t.z() * above;
}

double Room::clearance(const std::vector<Ball>& needle, const Eigen::Isometry3d& X_WT,
                       double least_wanted) const {
  double least = free_room;
  for (const Ball& ball : needle) {
    least = std::min(least, at(X_WT * ball.p_T) - ball.r);
    if (least < least_wanted) break;
  }
  return least;
}

}  // namespace fulcrum::content
