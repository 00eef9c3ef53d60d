#include "tools/content/plate/faces.h"

#include "haptics/math/functions.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector2d;

constexpr double tilt_step = 30.0 * degree;
constexpr double level_width = 60.0 * mm;
constexpr double tilted_width = 48.0 * mm;

Vector2d along(double tilt) {
  return {math::cos(tilt), -math::sin(tilt)};
}

Vector2d outward(double tilt) {
  return {math::sin(tilt), math::cos(tilt)};
}

double width_of(std::size_t face) {
  return face == 0 ? level_width : tilted_width;
}

}  // namespace

std::array<Face, face_count> faces() {
  std::array<Face, face_count> result;
  const auto corners = chain(0.0);
  for (std::size_t i = 0; i < face_count; ++i) {
    const double tilt = tilt_step * static_cast<double>(i);
    const Vector2d centre = 0.5 * (corners[i] + corners[i + 1]);
    const Vector2d normal = outward(tilt);
    result[i] = {.tilt = tilt,
                 .width = width_of(i),
                 .centre_W = drawing_in_world() * Eigen::Vector3d(centre.x(), centre.y(), 0.0),
                 .nhat_W = drawing_in_world() * Eigen::Vector3d(normal.x(), normal.y(), 0.0)};
  }
  return result;
}

Eigen::Isometry3d drawing_in_world() {
  Eigen::Isometry3d X = Eigen::Isometry3d::Identity();
  X.linear().diagonal() << -1.0, 1.0, -1.0;
  return X;
}

std::array<Vector2d, face_count + 1> chain(double depth) {
  std::array<Vector2d, face_count + 1> corners;
  Vector2d corner(-0.5 * level_width, 0.0);
  for (std::size_t i = 0; i <= face_count; ++i) {
    const double tilt = tilt_step * static_cast<double>(i);
    // Between two faces both move inwards by the depth; at the ends there is only one.
    const bool between = i > 0 && i < face_count;
    const double middle = between ? tilt - 0.5 * tilt_step : (i == 0 ? tilt : tilt - tilt_step);
    const double far = between ? depth / math::cos(0.5 * tilt_step) : depth;
    corners[i] = corner - far * outward(middle);
    if (i < face_count) corner += width_of(i) * along(tilt);
  }
  return corners;
}

}  // namespace fulcrum::content
