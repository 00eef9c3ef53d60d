#include "tools/content/plate/table_face.h"

#include <cmath>

#include "haptics/math/functions.h"
#include "tools/content/mesh/paint.h"
#include "tools/content/mesh/smooth.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int pixels_per_pitch = 128;
constexpr double pixel = hole_pitch / pixels_per_pitch;
constexpr double hole_radius = 3.1 * mm;
constexpr double countersink_radius = 3.9 * mm;  // its wall goes down at 45 degrees

const Vector3d steel(0.19, 0.2, 0.21);
const Vector3d cut(0.55, 0.55, 0.55);
const Vector3d dark(0.012, 0.012, 0.012);

// As f is in the middle, and the same at opposite sides.
template <typename F>
double without_seam(const Vector2d& at, double side, F f) {
  double sum = 0.0;
  for (const double i : {0.0, 1.0})
    for (const double k : {0.0, 1.0}) {
      const double weight = std::abs(1.0 - i - at.x() / side) * std::abs(1.0 - k - at.y() / side);
      sum += weight * f(Vector2d(at.x() - i * side, at.y() - k * side));
    }
  return sum;
}

// How much of a pixel lies within that radius, whose middle is at distance d from the circle's.
double within(double d, double radius) {
  return 1.0 - smooth_step(radius - 0.7 * pixel, radius + 0.7 * pixel, d);
}

struct Place {
  Vector3d colour;  // linear
  double metallic, roughness;
  Vector3d normal;
};

// p: m, from the corner; side: m, of the whole picture.
Place place_at(const Vector2d& p, double side) {
  const double clouds = without_seam(
      p, side,
      [](const Vector2d& q) {
        return mottle(Vector3d(110.0 * q.x(), 130.0 * q.y(), 0.4)) +
               0.5 * mottle(Vector3d(420.0 * q.y(), 390.0 * q.x(), 1.7));
      });
  const double grain = without_seam(p, side, [](const Vector2d& q) {
    return mottle(Vector3d(2900.0 * q.x() + 800.0 * q.y(), 3300.0 * q.y() - 700.0 * q.x(), 2.9));
  });
  Place place{(1.0 + 0.05 * clouds + 0.04 * grain) * steel, 0.35, 0.5 - 0.06 * clouds, Vector3d::UnitZ()};
  const Vector2d from_hole(std::fmod(p.x(), hole_pitch) - 0.5 * hole_pitch,
                           std::fmod(p.y(), hole_pitch) - 0.5 * hole_pitch);
  const double d = from_hole.norm();
  const double wall = within(d, countersink_radius);
  const double hole = within(d, hole_radius);
  place.colour = mixed(mixed(place.colour, cut, wall), dark, hole);
  place.metallic = std::lerp(std::lerp(place.metallic, 0.6, wall), 0.0, hole);
  place.roughness = std::lerp(std::lerp(place.roughness, 0.4, wall), 0.9, hole);
  if (wall > hole) {  // down towards the middle; v grows downwards in the picture
    const Vector3d slope(-from_hole.x() / d, from_hole.y() / d, 1.0);
    place.normal = mixed(place.normal, slope.normalized(), wall - hole).normalized();
  }
  return place;
}

}  // namespace

Pictures table_face(int pitches) {
  const int size = pixels_per_pitch * pitches;
  Pictures pictures{Raster(size, size), Raster(size, size), Raster(size, size)};
  for (int row = 0; row < size; ++row)
    for (int column = 0; column < size; ++column) {
      const Place place = place_at(pixel * Vector2d(column + 0.5, row + 0.5), pitches * hole_pitch);
      pictures.base_colour->set(column, row, srgb_encoded(place.colour));
      pictures.metal_rough->set(column, row, {0.0, place.roughness, place.metallic});
      pictures.normal->set(column, row, as_colour(place.normal));
    }
  return pictures;
}

}  // namespace fulcrum::content
