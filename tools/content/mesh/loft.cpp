#include "tools/content/mesh/loft.h"

#include "haptics/math/functions.h"

namespace fulcrum::content {
namespace {

void bridge(Solid* solid, std::uint32_t lower, std::uint32_t upper, std::uint32_t n) {
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t next = (k + 1) % n;
    solid->add_quad(lower + k, lower + next, upper + next, upper + k);
  }
}

Solid stacked(std::span<const Section> sections) {
  Solid solid;
  const auto n = static_cast<std::uint32_t>(sections.front().size());
  for (const Section& section : sections) {
    const auto first = static_cast<std::uint32_t>(solid.points.size());
    for (const Eigen::Vector3d& p : section) solid.add_point(p);
    if (first > 0) bridge(&solid, first - n, first, n);
  }
  return solid;
}

void cap_with_fan(Solid* solid, std::uint32_t first, std::uint32_t n, bool is_start) {
  Eigen::Vector3d sum = Eigen::Vector3d::Zero();
  for (std::uint32_t k = 0; k < n; ++k) sum += solid->points[first + k];
  const std::uint32_t centre = solid->add_point(sum / n);
  for (std::uint32_t k = 0; k < n; ++k) {
    const std::uint32_t a = first + k;
    const std::uint32_t b = first + (k + 1) % n;
    if (is_start)
      solid->add_triangle(centre, b, a);
    else
      solid->add_triangle(centre, a, b);
  }
}

void cap_with_strip(Solid* solid, std::uint32_t first, std::uint32_t n, bool is_start) {
  for (std::uint32_t k = 0; k + 1 < n / 2; ++k) {
    const std::uint32_t a = first + k;
    const std::uint32_t b = first + n - 1 - k;
    if (is_start)
      solid->add_quad(a, b, b - 1, a + 1);
    else
      solid->add_quad(a, a + 1, b - 1, b);
  }
}

std::vector<Section> turned(std::span<const RadiusHeight> profile, int columns) {
  std::vector<Section> sections;
  for (const RadiusHeight& at : profile) {
    Section& section = sections.emplace_back();
    for (int k = 0; k < columns; ++k) {
      const double angle = 2.0 * pi * k / columns;
      section.emplace_back(at.r * math::cos(angle), at.r * math::sin(angle), at.z);
    }
  }
  return sections;
}

}  // namespace

Solid loft(std::span<const Section> sections, Cap cap) {
  Solid solid = stacked(sections);
  const auto n = static_cast<std::uint32_t>(sections.front().size());
  const auto last = static_cast<std::uint32_t>(sections.size() - 1) * n;
  const auto close = cap == Cap::fan ? cap_with_fan : cap_with_strip;
  close(&solid, 0, n, true);
  close(&solid, last, n, false);
  turn_outward(&solid);
  return solid;
}

Solid closed_loft(std::span<const Section> sections) {
  Solid solid = stacked(sections);
  const auto n = static_cast<std::uint32_t>(sections.front().size());
  bridge(&solid, static_cast<std::uint32_t>(sections.size() - 1) * n, 0, n);
  turn_outward(&solid);
  return solid;
}

Solid lathe(std::span<const RadiusHeight> profile, int columns) {
  return loft(turned(profile, columns));
}

Solid lathe_ring(std::span<const RadiusHeight> profile, int columns) {
  return closed_loft(turned(profile, columns));
}

Solid chamfered_box(const Eigen::Vector3d& half, double chamfer) {
  const auto section = [&](double inset, double z) {
    const double a = half.x() - inset;
    const double b = half.y() - inset;
    const double c = chamfer;
    return Section{{a, -b + c, z}, {a, b - c, z},   {a - c, b, z},   {-a + c, b, z},
                   {-a, b - c, z}, {-a, -b + c, z}, {-a + c, -b, z}, {a - c, -b, z}};
  };
  const double h = half.z();
  const std::vector<Section> sections{section(chamfer, -h), section(0.0, -h + chamfer),
                                      section(0.0, h - chamfer), section(chamfer, h)};
  return loft(sections);
}

}  // namespace fulcrum::content
