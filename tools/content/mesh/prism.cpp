#include "tools/content/mesh/prism.h"

#include <algorithm>
#include <cmath>

#include "tools/content/mesh/loft.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector2d;

Vector2d unit_side(const Outline& outline, std::size_t i) {
  return (outline[(i + 1) % outline.size()] - outline[i]).normalized();
}

// The outline's corners cut by `cut` along each side, at a height.
Section cut_section(const Outline& outline, double cut, double z) {
  Section section;
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2d before = outline[i] - cut * unit_side(outline, (i + n - 1) % n);
    const Vector2d after = outline[i] + cut * unit_side(outline, i);
    section.emplace_back(before.x(), before.y(), z);
    section.emplace_back(after.x(), after.y(), z);
  }
  return section;
}

}  // namespace

Outline inset(const Outline& outline, double by) {
  Outline result;
  const std::size_t n = outline.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Vector2d in = unit_side(outline, (i + n - 1) % n);
    const Vector2d out = unit_side(outline, i);
    // Along the bisector, so far that both sides have moved by the distance.
    const Vector2d inwards = Vector2d(-in.y(), in.x()) + Vector2d(-out.y(), out.x());
    result.push_back(outline[i] + 2.0 * by / inwards.squaredNorm() * inwards);
  }
  return result;
}

Solid bevelled_prism(const Outline& outline, double half, double bevel, double step) {
  const Outline inner = inset(outline, bevel);
  const double length = 2.0 * (half - bevel);
  const int pieces = std::max(1, static_cast<int>(std::ceil(length / step)));
  std::vector<Section> sections{cut_section(inner, bevel, -half)};
  for (int k = 0; k <= pieces; ++k)
    sections.push_back(cut_section(outline, bevel, -half + bevel + length * k / pieces));
  sections.push_back(cut_section(inner, bevel, half));
  return loft(sections);
}

Solid bevelled_frame(const Outline& outline, double half, double bar, double bevel) {
  const Outline rim = inset(outline, bevel);
  const Outline sill = inset(outline, bar - bevel);
  const Outline window = inset(outline, bar);
  std::vector<Section> sections;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const auto at = [](const Vector2d& p, double z) { return Eigen::Vector3d(p.x(), p.y(), z); };
    const double side = half - bevel;
    sections.push_back({at(outline[i], -side), at(outline[i], side), at(rim[i], half), at(sill[i], half),
                        at(window[i], side), at(window[i], -side), at(sill[i], -half), at(rim[i], -half)});
  }
  return closed_loft(sections);
}

}  // namespace fulcrum::content
