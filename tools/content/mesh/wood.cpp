#include "tools/content/mesh/wood.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/functions.h"
#include "tools/content/mesh/loft.h"
#include "tools/content/mesh/paint.h"
#include "tools/content/mesh/smooth.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr double board_bevel = 1.5 * mm;
constexpr double across = 1.2 * mm;       // between points across the grain, where rings are crossed
constexpr double along_grain = 5.0 * mm;  // between points along the grain

// A ring begins light, grows darker and ends at once; trunks are not quite round and not quite straight.
Vector3d colour_at(const Vector3d& p, const Wood& wood) {
  const Vector3d slow(0.05 * p.x(), 0.05 * p.y(), 0.011 * p.z());
  const double r = math::hypot(p.x() - wood.pith.x(), p.y() - wood.pith.y()) + 2.6 * mottle(slow);
  const double t = r / wood.ring - std::floor(r / wood.ring);
  const double late = smooth_step(0.25, 0.85, t) * (1.0 - smooth_step(0.85, 1.0, t));
  const double fibre = mottle(Vector3d(2.9 * p.x(), 3.1 * p.y(), 0.09 * p.z()));
  return mixed(wood.early, wood.late, 0.75 * late + 0.14 * fibre + 0.1);
}

// Points on the way from a to b, without b.
void divide(Section* section, const Vector3d& a, const Vector3d& b) {
  const int pieces = std::max(1, static_cast<int>(std::ceil((b - a).norm() / across)));
  for (int k = 0; k < pieces; ++k) section->push_back(a + (b - a) * k / pieces);
}

Section board_section(const Vector3d& half, double inset, double z) {
  const double a = half.x() - inset;
  const double b = half.y() - inset;
  const double c = board_bevel;
  const Vector3d corners[] = {{a, -b + c, z}, {a, b - c, z},   {a - c, b, z},   {-a + c, b, z},
                              {-a, b - c, z}, {-a, -b + c, z}, {-a + c, -b, z}, {a - c, -b, z}};
  Section section;
  for (std::size_t i = 0; i < 8; ++i) {
    // Bevels stay whole, and what is inset has as many points as what is not.
    const Vector3d from = corners[i];
    const Vector3d to = corners[(i + 1) % 8];
    if (i % 2 == 1) {
      section.push_back(from);
      continue;
    }
    Section full;
    const bool upright = i % 4 == 0;
    const double length = 2.0 * ((upright ? half.y() : half.x()) - c);
    divide(&full, Vector3d::Zero(), length * Vector3d::UnitX());
    for (const Vector3d& p : full) section.push_back(from + p.x() / length * (to - from));
  }
  return section;
}

}  // namespace

Coat grained(const Solid& solid, const Wood& wood) {
  Coat coat;
  for (const Vector3d& p : solid.points) coat.colours.push_back(colour_at(p / mm, wood));
  return coat;
}

Part board(const std::string& name, const Vector3d& half, const Wood& wood) {
  std::vector<Section> sections{board_section(half, board_bevel, -half.z())};
  const double length = 2.0 * (half.z() - board_bevel);
  const int pieces = static_cast<int>(std::ceil(length / along_grain));
  for (int k = 0; k <= pieces; ++k)
    sections.push_back(board_section(half, 0.0, -half.z() + board_bevel + length * k / pieces));
  sections.push_back(board_section(half, board_bevel, half.z()));
  Part part{.name = name, .material = 0, .solid = loft(sections)};
  part.coat = grained(part.solid, wood);
  // Across the grain wood is darker, and even: the outermost sections and the middles of the two ends.
  const std::size_t ring = sections.front().size();
  const std::size_t points = part.solid.points.size();
  for (std::size_t i = 0; i < points; ++i)
    if (i < ring || i + ring + 2 >= points) part.coat.colours[i] = 0.8 * mixed(wood.early, wood.late, 0.6);
  return part;
}

}  // namespace fulcrum::content
