#include "tools/content/plate/marks.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

#include "haptics/math/functions.h"
#include "tools/content/mesh/loft.h"
#include "tools/content/plate/faces.h"
#include "tools/content/plate/stand.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

// Strokes in the unit of a figure's height, x to the right and y up.
constexpr double letter_height = 6.5 * mm;
constexpr double stroke = 0.55 * mm;  // half its width
constexpr double advance = 0.78;      // from figure to figure
constexpr double figure_width = 0.56;

using Line = std::vector<Vector2d>;

Line arc(const Vector2d& centre, const Vector2d& radii, double from_deg, double to_deg) {
  constexpr int pieces = 36;
  Line line;
  for (int k = 0; k <= pieces; ++k) {
    const double angle = degree * (from_deg + (to_deg - from_deg) * k / pieces);
    line.emplace_back(centre + radii.cwiseProduct(Vector2d(math::cos(angle), math::sin(angle))));
  }
  return line;
}

Line ring(const Vector2d& centre, const Vector2d& radii) {
  Line line = arc(centre, radii, 0.0, 360.0);
  line.back() = line.front();
  return line;
}

std::vector<Line> six() {
  return {ring({0.28, 0.28}, {0.27, 0.28}), arc({0.61, 0.32}, {0.6, 0.68}, 105.0, 176.0)};
}

std::vector<Line> strokes(char figure) {
  switch (figure) {
    case '0':
      return {ring({0.28, 0.5}, {0.27, 0.5})};
    case '3':
      return {arc({0.26, 0.76}, {0.24, 0.24}, 155.0, -90.0), arc({0.26, 0.26}, {0.28, 0.26}, 90.0, -155.0)};
    case '6':
      return six();
    case '9': {
      std::vector<Line> lines = six();
      for (Line& line : lines)
        for (Vector2d& p : line) p = Vector2d(figure_width, 1.0) - p;
      return lines;
    }
    default:  // the sign for degrees
      return {ring({0.13, 0.87}, {0.12, 0.13})};
  }
}

// A round stroke that is sunk into its face as deep as it can be and still be seen. A line that ends where it
// begins is a ring.
Solid drawn(const Line& line, const Eigen::Isometry3d& X_WF) {
  constexpr int corners = 10;
  const std::size_t last = line.size() - 1;
  const bool closed = (line.front() - line.back()).norm() < 1e-9;
  std::vector<Section> sections;
  for (std::size_t i = 0; i < line.size() - (closed ? 1 : 0); ++i) {
    const Vector2d& before = i > 0 ? line[i - 1] : closed ? line[last - 1] : line[0];
    const Vector2d along = (line[std::min(i + 1, last)] - before).normalized();
    const Vector3d across(along.y(), -along.x(), 0.0);
    const Vector3d middle(letter_height * line[i].x(), letter_height * line[i].y(), -0.7 * stroke);
    Section& section = sections.emplace_back();
    for (int k = 0; k < corners; ++k) {
      const double angle = 2.0 * pi * (k + 0.5) / corners;
      section.push_back(
          X_WF * (middle + stroke * (math::cos(angle) * across + math::sin(angle) * Vector3d::UnitZ())));
    }
  }
  return closed ? closed_loft(sections) : loft(sections);
}

}  // namespace

Model make_marks() {
  Model model{.name = "marks",
              .materials = {{.name = "white paint",
                             .base_colour = {0.82, 0.82, 0.8},
                             .metallic = 0.0,
                             .roughness = 0.6}},
              .parts = {}};
  const auto all = faces();
  for (const Face& face : all) {
    const std::string text = std::to_string(static_cast<int>(std::lround(face.tilt / degree))) + "*";
    Eigen::Isometry3d X_WF = Eigen::Isometry3d::Identity();
    X_WF.linear() << face.along_W(), face.nhat_W, Vector3d::UnitZ();
    X_WF.translation() = face.centre_W - (plate_thickness + 0.5 * (frame_bar + letter_height)) * face.nhat_W +
                         frame_half_depth * Vector3d::UnitZ();
    // Centred without the sign for degrees.
    double x = -0.5 * (advance * static_cast<double>(text.size() - 2) + figure_width);
    for (const char figure : text) {
      for (Line line : strokes(figure)) {
        for (Vector2d& p : line) p.x() += x;
        model.parts.push_back({.name = "mark/" + std::to_string(model.parts.size() + 1),
                               .material = 0,
                               .solid = drawn(line, X_WF)});
      }
      x += advance;
    }
  }
  return model;
}

}  // namespace fulcrum::content
