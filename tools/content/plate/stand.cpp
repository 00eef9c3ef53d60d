#include "tools/content/plate/stand.h"

#include <random>

#include "haptics/math/rotation.h"
#include "tools/content/mesh/loft.h"
#include "tools/content/plate/faces.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double joint = 0.5 * mm;  // half of what is left between two plates
constexpr double brush_step = 0.35 * mm;
constexpr double frame_foot = -124.0 * mm;  // y of the frame's underside
constexpr double base_top = -172.0 * mm;
constexpr double base_bottom = -190.0 * mm;
const Vector3d base_middle(-28.0 * mm, 0.5 * (base_top + base_bottom), 0.0);
const Vector3d base_half(112.0 * mm, 0.5 * (base_top - base_bottom), 78.0 * mm);

// A section through a plate: mitred where it meets its neighbour.
Outline plate_outline(std::size_t face) {
  const auto top = chain(0.0);
  const auto bottom = chain(plate_thickness);
  const Vector2d along = (top[face + 1] - top[face]).normalized();
  const Vector2d left = face == 0 ? Vector2d::Zero() : Vector2d(joint * along);
  const Vector2d right = face + 1 == face_count ? Vector2d::Zero() : Vector2d(joint * along);
  return {bottom[face] + left, bottom[face + 1] - right, top[face + 1] - right, top[face] + left};
}

// Marks of the brush, along the plate: each a little lighter or darker than the one beside it.
Coat brushed(const Solid& solid, unsigned seed) {
  constexpr std::size_t section = 8;
  std::mt19937 random(seed);
  Coat coat;
  double tone = 1.0;
  for (std::size_t i = 0; i < solid.points.size(); ++i) {
    if (i % section == 0)
      tone = 0.84 + 0.16 * static_cast<double>(random()) / static_cast<double>(random.max());
    coat.colours.push_back(Vector3d::Constant(tone));
  }
  return coat;
}

Solid placed(const Solid& solid, const Vector3d& p) {
  return transformed(solid, Eigen::Isometry3d(Eigen::Translation3d(p)));
}

Solid upright(std::span<const RadiusHeight> profile, int columns, const Vector3d& foot) {
  return transformed(lathe(profile, columns), frame_along(foot, Vector3d::UnitY()));
}

// A little into the plates, so that no two faces coincide.
Outline frame_outline() {
  const auto corners = chain(plate_thickness - 0.2 * mm);
  const double left = corners.front().x() + 2.0 * mm;
  Outline outline{{left, frame_foot}, {corners.back().x(), frame_foot}};
  for (std::size_t i = face_count; i > 0; --i) outline.push_back(corners[i]);
  outline.emplace_back(left, corners.front().y());
  // The upright plate's corner is a point on a straight side: the frame goes straight down from there.
  outline.erase(outline.begin() + 2);
  return outline;
}

void add_feet(Model* model, std::size_t metal, std::size_t rubber) {
  constexpr RadiusHeight pad[] = {{8 * mm, 0.0}, {9 * mm, 1 * mm}, {9 * mm, 4 * mm}, {8 * mm, 5 * mm}};
  constexpr RadiusHeight screw[] = {{4 * mm, 4 * mm},   {4 * mm, 8 * mm},     {7.4 * mm, 8 * mm},
                                    {8 * mm, 8.6 * mm}, {8 * mm, 11 * mm},    {4 * mm, 11 * mm},
                                    {4 * mm, 31 * mm},  {3.4 * mm, 31.6 * mm}};
  constexpr RadiusHeight nut[] = {
      {6 * mm, 27.5 * mm}, {6.5 * mm, 28.5 * mm}, {6.5 * mm, 30 * mm}, {6 * mm, 30.4 * mm}};
  int number = 0;
  for (const double x : {-1.0, 1.0}) {
    for (const double z : {-1.0, 1.0}) {
      const Vector3d foot(base_middle.x() + x * (base_half.x() - 15 * mm), bench_height,
                          z * (base_half.z() - 15 * mm));
      const std::string name = std::to_string(++number);
      model->parts.push_back({.name = "pad/" + name, .material = rubber, .solid = upright(pad, 32, foot)});
      model->parts.push_back({.name = "screw/" + name, .material = metal, .solid = upright(screw, 32, foot)});
      model->parts.push_back({.name = "nut/" + name, .material = metal, .solid = upright(nut, 6, foot)});
    }
  }
}

}  // namespace

Model make_plates() {
  Model model{.name = "plate",
              .materials = {{.name = "brushed steel",
                             .base_colour = {0.68, 0.68, 0.69},
                             .metallic = 1.0,
                             .roughness = 0.34}},
              .parts = {}};
  const char* names[] = {"level", "tilted_30", "tilted_60", "upright"};
  for (std::size_t i = 0; i < face_count; ++i) {
    Solid solid = transformed(bevelled_prism(plate_outline(i), face_half_depth, 0.8 * mm, brush_step),
                              drawing_in_world());
    Coat coat = brushed(solid, static_cast<unsigned>(i + 1));
    model.parts.push_back(
        {.name = names[i], .material = 0, .solid = std::move(solid), .coat = std::move(coat)});
  }
  return model;
}

Model make_stand() {
  Model model{
      .name = "stand",
      .materials =
          {{.name = "anodised", .base_colour = {0.035, 0.038, 0.043}, .metallic = 0.0, .roughness = 0.42},
           {.name = "turned steel", .base_colour = {0.5, 0.5, 0.51}, .metallic = 1.0, .roughness = 0.28},
           {.name = "rubber", .base_colour = {0.02, 0.02, 0.02}, .metallic = 0.0, .roughness = 0.8}},
      .parts = {}};
  model.parts.push_back(
      {.name = "frame",
       .material = 0,
       .solid = transformed(bevelled_frame(frame_outline(), frame_half_depth, frame_bar, 1.2 * mm),
                            drawing_in_world()),
       .crease = 25 * degree});
  constexpr RadiusHeight column[] = {{30 * mm, 0.0},     {31 * mm, 1 * mm},    {31 * mm, 7 * mm},
                                     {30 * mm, 8 * mm},  {24 * mm, 8.4 * mm},  {22.6 * mm, 9.2 * mm},
                                     {22 * mm, 11 * mm}, {22 * mm, 40 * mm},   {22.6 * mm, 42 * mm},
                                     {24 * mm, 43 * mm}, {30 * mm, 43.4 * mm}, {31 * mm, 44.4 * mm},
                                     {31 * mm, 50 * mm}};
  model.parts.push_back({.name = "column",
                         .material = 1,
                         .solid = upright(column, 96, {base_middle.x(), base_top - 1 * mm, 0.0})});
  const Eigen::Isometry3d lying(turn_by(-0.5 * pi, Vector3d::UnitX()));
  const Vector3d half(base_half.x(), base_half.z(), base_half.y());
  model.parts.push_back({.name = "base",
                         .material = 0,
                         .solid = placed(transformed(chamfered_box(half, 1.5 * mm), lying), base_middle)});
  add_feet(&model, 1, 2);
  return model;
}

}  // namespace fulcrum::content
