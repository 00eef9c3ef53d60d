#include "tools/content/mesh/painted_line.h"

#include <algorithm>

#include "haptics/math/functions.h"
#include "tools/content/mesh/loft.h"

namespace fulcrum::content {

using Eigen::Vector2d;
using Eigen::Vector3d;

PaintedLine arc(const Vector2d& centre, const Vector2d& radii, double from_deg, double to_deg) {
  constexpr int pieces = 36;
  PaintedLine line;
  for (int k = 0; k <= pieces; ++k) {
    const double angle = degree * (from_deg + (to_deg - from_deg) * k / pieces);
    line.emplace_back(centre + radii.cwiseProduct(Vector2d(math::cos(angle), math::sin(angle))));
  }
  return line;
}

PaintedLine ring(const Vector2d& centre, const Vector2d& radii) {
  PaintedLine line = arc(centre, radii, 0.0, 360.0);
  line.back() = line.front();
  return line;
}

Solid painted(const PaintedLine& line, double unit, double half, const Eigen::Isometry3d& X_WF) {
  constexpr int corners = 10;
  const std::size_t last = line.size() - 1;
  const bool closed = (line.front() - line.back()).norm() < 1e-9;
  std::vector<Section> sections;
  for (std::size_t i = 0; i < line.size() - (closed ? 1 : 0); ++i) {
    const Vector2d& before = i > 0 ? line[i - 1] : closed ? line[last - 1] : line[0];
    const Vector2d along = (line[std::min(i + 1, last)] - before).normalized();
    const Vector3d across(along.y(), -along.x(), 0.0);
    const Vector3d middle(unit * line[i].x(), unit * line[i].y(), -0.7 * half);
    Section& section = sections.emplace_back();
    for (int k = 0; k < corners; ++k) {
      const double angle = 2.0 * pi * (k + 0.5) / corners;
      section.push_back(X_WF *
                        (middle + half * (math::cos(angle) * across + math::sin(angle) * Vector3d::UnitZ())));
    }
  }
  return closed ? closed_loft(sections) : loft(sections);
}

}  // namespace fulcrum::content
