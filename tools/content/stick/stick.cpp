#include "tools/content/stick/stick.h"

#include <cmath>
#include <vector>

#include "haptics/math/functions.h"
#include "tools/content/mesh/loft.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr int columns = 60;
constexpr double strip_half = 75.0 * degree;  // of the stick's girth, about the top
constexpr double mark_half = 0.28 * mm;
constexpr double edge = 0.03 * mm;  // over which a colour gives way to the next
constexpr double mark_step = 10.0 * mm;

const Vector3d carbon(0.022, 0.023, 0.026);
const Vector3d border(0.30, 0.31, 0.32);
const Vector3d strip(0.88, 0.33, 0.02);
const Vector3d ink(0.012, 0.012, 0.012);

Solid along_x(std::span<const RadiusHeight> profile, int around, const Vector3d& from = Vector3d::Zero()) {
  return transformed(lathe(profile, around), frame_along(from, Vector3d::UnitX()));
}

// Sections where a colour begins or ends, and a round end.
std::vector<RadiusHeight> stick_profile() {
  std::vector<RadiusHeight> profile{{stick_radius, 12.0 * mm}};
  const auto sharp = [&](double at) {
    profile.push_back({stick_radius, at - edge});
    profile.push_back({stick_radius, at + edge});
  };
  sharp(strip_from - 2.0 * mm);
  for (double at = strip_from; at < strip_to + 0.5 * mark_step; at += mark_step) {
    sharp(at - mark_half);
    sharp(at + mark_half);
  }
  sharp(strip_to + 2.0 * mm);
  constexpr int steps = 10;
  for (int k = 0; k < steps; ++k) {
    const double angle = 0.5 * pi * k / steps;
    profile.push_back(
        {stick_radius * math::cos(angle), stick_length - stick_radius * (1.0 - math::sin(angle))});
  }
  return profile;
}

Vector3d rod_colour(const Vector3d& p) {
  const double from_top = std::abs(math::atan2(p.z(), p.y()));
  if (p.x() < strip_from - 2.0 * mm || p.x() > strip_to + 2.0 * mm || from_top > strip_half) return carbon;
  const long mark = std::lround((p.x() - strip_from) / mark_step);
  const bool long_mark = (mark + 3) % 5 == 0;  // 50, 100 and 150 mm
  if (std::abs(p.x() - strip_from - static_cast<double>(mark) * mark_step) < mark_half)
    return from_top < (long_mark ? 64.0 : 34.0) * degree ? ink : strip;
  return from_top > strip_half - 9.0 * degree ? border : strip;
}

// The stage: a drum that turns about z, and the collar that the stick sits in. The joints of the device that
// meet in it are drawn with the device.
void add_stage(Model* model, std::size_t dark, std::size_t bright) {
  const auto add = [&](const char* name, std::size_t material, Solid solid) {
    model->parts.push_back({.name = name, .material = material, .solid = std::move(solid)});
  };
  constexpr RadiusHeight drum[] = {
      {8 * mm, -15 * mm}, {9 * mm, -14.2 * mm}, {9 * mm, 14.2 * mm}, {8 * mm, 15 * mm}};
  constexpr RadiusHeight cap[] = {
      {5.4 * mm, -16.2 * mm}, {6 * mm, -15.6 * mm}, {6 * mm, 15.6 * mm}, {5.4 * mm, 16.2 * mm}};
  constexpr RadiusHeight collar[] = {{7.4 * mm, 5 * mm},  {7.4 * mm, 14 * mm}, {7 * mm, 14.6 * mm},
                                     {5.6 * mm, 15 * mm}, {5.6 * mm, 20 * mm}, {5.2 * mm, 20.4 * mm}};
  constexpr RadiusHeight ring[] = {
      {7.4 * mm, 11 * mm}, {7.8 * mm, 11.3 * mm}, {7.8 * mm, 13.2 * mm}, {7.4 * mm, 13.5 * mm}};
  add("drum", dark, lathe(drum, 64));
  add("cap", bright, lathe(cap, 48));
  add("collar", dark, along_x(collar, 48));
  add("ring", bright, along_x(ring, 48));
}

}  // namespace

Model make_stick() {
  Model model{
      .name = "stick",
      .materials =
          {{.name = "stick", .base_colour = {1, 1, 1}, .metallic = 0.0, .roughness = 0.38},
           {.name = "anodised", .base_colour = {0.028, 0.032, 0.042}, .metallic = 0.35, .roughness = 0.36},
           {.name = "brass", .base_colour = {0.83, 0.60, 0.26}, .metallic = 1.0, .roughness = 0.30}},
      .parts = {}};
  Solid rod = along_x(stick_profile(), columns);
  Coat coat;
  for (const Vector3d& p : rod.points) coat.colours.push_back(rod_colour(p));
  model.parts.push_back({.name = "rod",
                         .material = 0,
                         .solid = std::move(rod),
                         .crease = 50 * degree,
                         .coat = std::move(coat)});
  add_stage(&model, 1, 2);
  return model;
}

}  // namespace fulcrum::content
