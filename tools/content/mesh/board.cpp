#include "tools/content/mesh/board.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "tools/content/mesh/loft.h"
#include "tools/content/mesh/paint.h"
#include "tools/content/mesh/smooth.h"

namespace fulcrum::content {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double bevel = 1.5 * mm;
constexpr double across = 0.4 * mm;       // from pixel to pixel across the grain, where rings are crossed
constexpr double along_grain = 1.0 * mm;  // and along it
constexpr int margin = 4;                 // pixels about a face, so that coarser pictures mix in its own wood

// A face and its place in the board's picture, where columns go along `u` and rows along `v`.
struct Face {
  Vector3d middle, u, v;  // m, unit, unit
  Vector2d pixel;         // m, from one to the next
  int columns, rows;      // without its margins
  int first_column = 0, first_row = 0;

  Vector3d at(double column, double row) const {
    return middle + pixel.x() * (column - first_column - 0.5 * columns) * u +
           pixel.y() * (row - first_row - 0.5 * rows) * v;
  }
  bool is_end() const { return u.z() == 0.0; }
};

Face face_of(const Vector3d& half, const Vector3d& outward, const Vector3d& u) {
  const Vector3d v = u.cross(outward);  // rows grow downwards
  const Vector2d pixel(u.z() != 0.0 ? along_grain : across, across);
  const auto pixels = [&](const Vector3d& axis, double size) {
    return static_cast<int>(std::ceil(2.0 * half.dot(axis.cwiseAbs()) / size));
  };
  return {half.dot(outward.cwiseAbs()) * outward, u, v, pixel, pixels(u, pixel.x()), pixels(v, pixel.y())};
}

// The four along the grain one below the other, and the two ends to the right of them.
struct Layout {
  std::array<Face, 6> faces;
  int columns = 0, rows = 0;
};

Layout layout_of(const Vector3d& half) {
  const Vector3d x = Vector3d::UnitX(), y = Vector3d::UnitY(), z = Vector3d::UnitZ();
  const Vector3d& thin = half.x() < half.y() ? x : y;
  Layout layout{{face_of(half, y, z), face_of(half, x, z), face_of(half, -y, z), face_of(half, -x, z),
                 face_of(half, z, thin), face_of(half, -z, thin)}};
  int row = 0, end_row = 0;
  const int first_of_ends = layout.faces[0].columns + 2 * margin;
  for (Face& face : layout.faces) {
    int& below = face.is_end() ? end_row : row;
    face.first_column = margin + (face.is_end() ? first_of_ends : 0);
    face.first_row = margin + below;
    below += face.rows + 2 * margin;
    layout.columns = std::max(layout.columns, face.first_column + face.columns + margin);
    layout.rows = std::max(layout.rows, below);
  }
  return layout;
}

// Vessels that a saw has cut open: short dark strokes along the grain, of no row.
double pores(const Vector3d& p) {
  const double begins = 9.0 * mottle(Vector3d(2.3 * p.x() + 1.3 * p.y(), 2.1 * p.y() - 1.1 * p.x(), 0.7));
  const double vessel =
      mottle(Vector3d(4.7 * p.x() + 1.1 * p.y(), 4.9 * p.y() - 1.3 * p.x(), 0.27 * p.z() + begins));
  const double many = 0.35 * mottle(Vector3d(0.9 * p.x(), 0.8 * p.y(), 0.03 * p.z()));
  return smooth_step(0.3, 0.8, vessel + many);
}

Vector3d colour_of(const Face& face, const Vector3d& p, const Wood& wood) {
  const Vector3d colour = (1.0 - 0.38 * pores(p / mm)) * wood_colour(p / mm, wood);
  return face.is_end() ? Vector3d(0.8 * colour) : colour;  // across the grain it drinks more oil
}

Raster paint(const Layout& layout, const Wood& wood) {
  Raster picture(layout.columns, layout.rows);
  for (const Face& face : layout.faces)
    for (int row = face.first_row - margin; row < face.first_row + face.rows + margin; ++row)
      for (int column = face.first_column - margin; column < face.first_column + face.columns + margin;
           ++column)
        picture.set(column, row, srgb_encoded(colour_of(face, face.at(column + 0.5, row + 0.5), wood)));
  return picture;
}

Projection projection_of(const Face& face, const Layout& layout, const Isometry3d& X_WB) {
  return {.origin = X_WB * face.at(0.0, 0.0),
          .along_u = X_WB.linear() * face.u / (face.pixel.x() * layout.columns),
          .along_v = X_WB.linear() * face.v / (face.pixel.y() * layout.rows)};
}

}  // namespace

void add_board(Model* model, const Board& board, const Isometry3d& X_WB) {
  const Layout layout = layout_of(board.half);
  Part part{.name = board.name,
            .material = model->materials.size(),
            .solid = transformed(chamfered_box(board.half, bevel), X_WB)};
  for (const Face& face : layout.faces) part.projections.push_back(projection_of(face, layout, X_WB));
  model->parts.push_back(std::move(part));
  model->materials.push_back({.name = board.name,
                              .base_colour = {1.0, 1.0, 1.0},
                              .metallic = 0.0,
                              .roughness = board.roughness,
                              .pictures = Pictures{.base_colour = paint(layout, board.wood)}});
}

}  // namespace fulcrum::content
