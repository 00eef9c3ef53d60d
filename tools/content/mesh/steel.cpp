#include "tools/content/mesh/steel.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "haptics/math/functions.h"
#include "tools/content/mesh/paint.h"
#include "tools/content/mesh/smooth.h"
#include "tools/content/mesh/tileable.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr int steel_pixels = 256;
constexpr double mean_finish = 0.7;  // of the picture of roughness, which is times the material's
constexpr int paint_columns = 256, paint_rows = 512;

const Vector3d bare_steel_colour(0.40, 0.39, 0.37);  // what paint comes off from
const Vector3d primer_colour(0.10, 0.052, 0.035);    // about a chip
const Vector3d grime_colour(0.035, 0.03, 0.024);

// Height of the lines, 0 to 1.
double brush_lines(const Vector2d& uv) {
  return 0.4 * tileable_noise(uv, 2, 61, 1) + 0.35 * tileable_noise(uv, 3, 113, 2) +
         0.25 * tileable_noise(uv, 5, 128, 3);
}

double smudges(const Vector2d& uv) {
  return 0.6 * tileable_noise(uv, 3, 3, 4) + 0.4 * tileable_noise(uv, 7, 7, 5);
}

// How much of the paint is gone: 0 to 1, and above 0 it has cracked.
double chipped(const Vector2d& uv) {
  const double spots = 0.62 * tileable_noise(uv, 17, 34, 11) + 0.38 * tileable_noise(uv, 41, 82, 12);
  const double regions = tileable_noise(uv, 3, 5, 13);
  const double worn = bump(uv.y() - worn_at, 0.16);
  const double limit = 0.94 - 0.11 * worn - 0.07 * regions;
  return smooth_step(limit - 0.035, limit + 0.025, spots);
}

struct PaintedPlace {
  Vector3d colour;  // linear
  double metallic, roughness;
};

PaintedPlace painted_place(const Vector2d& uv, const Vector3d& paint) {
  const double clouds = 0.6 * tileable_noise(uv, 3, 6, 6) + 0.4 * tileable_noise(uv, 8, 16, 7);
  const double peel = tileable_noise(uv, 64, 128, 8);
  const double dirt = 0.45 * tileable_noise(uv, 4, 9, 9) + 0.27 * tileable_noise(uv, 11, 19, 10) +
                      0.17 * tileable_noise(uv, 23, 41, 14) + 0.11 * tileable_noise(uv, 47, 83, 15);
  const double film = smooth_step(0.5, 0.72, dirt);
  const double gone = chipped(uv);
  const double crack = smooth_step(0.0, 0.35, gone), steel = smooth_step(0.5, 0.9, gone);
  const Vector3d coat = mixed((0.93 + 0.14 * clouds) * paint, grime_colour, 0.3 * film);
  const Vector3d below = mixed(primer_colour, (0.85 + 0.3 * peel) * bare_steel_colour, steel);
  return {mixed(coat, below, crack), steel,
          std::lerp(0.36 + 0.06 * clouds + 0.05 * peel + 0.14 * film, std::lerp(0.6, 0.38, steel), crack)};
}

// Brushed along u, or turned where that goes round: fine lines, some of them duller, and where hands have
// been. A square of which the colour is about white, to be times the metal's.
Pictures brushed_steel() {
  constexpr double depth = 0.35;  // of the lines, in relation to how far they are apart
  constexpr double pixel = 1.0 / steel_pixels;
  Pictures pictures{Raster(steel_pixels, steel_pixels), Raster(steel_pixels, steel_pixels),
                    Raster(steel_pixels, steel_pixels)};
  for (int row = 0; row < steel_pixels; ++row)
    for (int column = 0; column < steel_pixels; ++column) {
      const Vector2d uv = pixel * Vector2d(column + 0.5, row + 0.5), half(0.0, 0.5 * pixel);
      const double line = brush_lines(uv), smudge = smudges(uv);
      const double shade = 0.89 + 0.22 * (line - 0.5) - 0.08 * (smudge - 0.5);
      pictures.base_colour->set(column, row, srgb_encoded(shade * Vector3d::Ones()));
      pictures.metal_rough->set(column, row,
                                {0.0, mean_finish + 0.35 * (smudge - 0.5) - 0.3 * (line - 0.5), 1.0});
      const double slope = depth * (brush_lines(uv + half) - brush_lines(uv - half));
      pictures.normal->set(column, row, as_colour(Vector3d(0.0, slope, 1.0).normalized()));
    }
  return pictures;
}

Vector3d normal_of(const Solid& solid, const Triangle& t) {
  const Vector3d& a = solid.points[t[0]];
  return (solid.points[t[1]] - a).cross(solid.points[t[2]] - a);
}

}  // namespace

Material brushed(const std::string& name, const std::array<double, 3>& base_colour, double roughness) {
  return {.name = name,
          .base_colour = base_colour,
          .metallic = 1.0,
          .roughness = std::min(1.0, roughness / mean_finish),
          .pictures = brushed_steel()};
}

Material painted(const std::string& name, const Vector3d& paint) {
  Pictures pictures{Raster(paint_columns, paint_rows), Raster(paint_columns, paint_rows)};
  for (int row = 0; row < paint_rows; ++row)
    for (int column = 0; column < paint_columns; ++column) {
      const PaintedPlace place =
          painted_place({(column + 0.5) / paint_columns, (row + 0.5) / paint_rows}, paint);
      pictures.base_colour->set(column, row, srgb_encoded(place.colour));
      pictures.metal_rough->set(column, row, {0.0, place.roughness, place.metallic});
    }
  return {.name = name,
          .base_colour = {1.0, 1.0, 1.0},
          .metallic = 1.0,
          .roughness = 1.0,
          .pictures = std::move(pictures)};
}

Coat worn(const Solid& solid) {
  std::vector<Vector3d> normals(solid.points.size(), Vector3d::Zero());
  for (const Triangle& t : solid.triangles)
    for (const std::uint32_t corner : t) normals[corner] += normal_of(solid, t);
  // How far a point stands out from those that it is joined to, as the sine of an angle.
  std::vector<double> out(solid.points.size(), 0.0), count(solid.points.size(), 0.0);
  for (const Triangle& t : solid.triangles)
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t at = t[k], other = t[(k + 1) % 3];
      out[at] += (solid.points[at] - solid.points[other]).normalized().dot(normals[at].normalized());
      count[at] += 1.0;
    }
  Coat coat;
  for (std::size_t i = 0; i < out.size(); ++i) {
    const double sharp = out[i] / std::max(1.0, count[i]);
    const double shade = 0.86 + 0.14 * smooth_step(0.01, 0.12, sharp) - 0.3 * smooth_step(0.01, 0.2, -sharp);
    coat.colours.emplace_back(shade * Vector3d::Ones());
  }
  return coat;
}

}  // namespace fulcrum::content
