#include "tools/content/plate/marks.h"

#include <cmath>
#include <string>
#include <utility>

#include "haptics/math/functions.h"
#include "tools/content/mesh/painted_line.h"
#include "tools/content/plate/faces.h"
#include "tools/content/plate/stand.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Line = PaintedLine;

// Strokes in the unit of a figure's height, x to the right and y up.
constexpr double letter_height = 6.5 * mm;
constexpr double stroke = 0.55 * mm;  // half its width
constexpr double advance = 0.78;      // from figure to figure
constexpr double figure_width = 0.56;

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
                               .solid = painted(line, letter_height, stroke, X_WF)});
      }
      x += advance;
    }
  }
  return model;
}

}  // namespace fulcrum::content
