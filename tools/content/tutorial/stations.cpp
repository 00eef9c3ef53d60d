#include "tools/content/tutorial/stations.h"

#include <cmath>
#include <string>
#include <utility>

#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"
#include "tools/content/mesh/board.h"
#include "tools/content/mesh/loft.h"
#include "tools/content/mesh/prism.h"
#include "tools/content/tutorial/places.h"

namespace fulcrum::content {
namespace {

using Eigen::Isometry3d;
using Eigen::Vector3d;

enum Material : std::size_t { steel, slate, rubber, brass, yellow, red };

constexpr double sunk = 0.5 * mm;  // of what stands on the panel, so that no two faces coincide

Solid on_panel(const Solid& solid, const Vector3d& p_P) {
  return transformed(solid, panel_in_world() * Eigen::Translation3d(p_P));
}

void add_panel(Model* model) {
  // The grain of a board runs along its z: here along the panel's x.
  Eigen::Matrix3d turn;
  turn.col(0) = Vector3d::UnitY();
  turn.col(1) = Vector3d::UnitZ();
  turn.col(2) = Vector3d::UnitX();
  Isometry3d X = Isometry3d::Identity();
  X.linear() = turn;
  add_board(model, {.name = "panel", .half = {panel_half.y(), panel_half.z(), panel_half.x()}, .wood = beech},
            panel_in_world() * Eigen::Translation3d(0.0, 0.0, -panel_half.z()) * X);
}

// A ring on a stalk that comes from below it.
void add_hoop(Model* model) {
  constexpr double wire = 2.6 * mm;
  std::vector<RadiusHeight> around;
  for (int k = 0; k < 20; ++k) {
    const double angle = 2.0 * pi * k / 20;
    around.push_back({hoop_radius + wire * math::cos(angle), wire * math::sin(angle)});
  }
  model->parts.push_back(
      {.name = "hoop/ring", .material = brass, .solid = on_panel(lathe_ring(around, 96), hoop_middle)});
  // Up to the ring's wire, and into it.
  const Vector3d foot(hoop_middle.x(), hoop_middle.y() - hoop_radius, 0.0);
  const double z = hoop_middle.z() + 0.5 * wire;
  const RadiusHeight stalk[] = {{2.4 * mm, -sunk}, {2.4 * mm, z - 1.0 * mm}, {1.4 * mm, z}};
  model->parts.push_back(
      {.name = "hoop/stalk", .material = brass, .solid = on_panel(lathe(stalk, 32), foot)});
  constexpr RadiusHeight rosette[] = {{10 * mm, -sunk},     {10 * mm, 2 * mm},  {9.4 * mm, 2.8 * mm},
                                      {5.0 * mm, 3.4 * mm}, {4.2 * mm, 5 * mm}, {4.0 * mm, 7 * mm},
                                      {3.2 * mm, 7.8 * mm}};
  model->parts.push_back(
      {.name = "hoop/rosette", .material = brass, .solid = on_panel(lathe(rosette, 48), foot)});
}

void add_slot(Model* model) {
  constexpr double bar = 16.0 * mm;
  const double a = slot_half_width + bar, b = slot_half_height + bar;
  const Outline outline{{-a, -b}, {a, -b}, {a, b}, {-a, b}};
  const double half = 0.5 * (slot_depth + sunk);
  model->parts.push_back({.name = "slot/box",
                          .material = slate,
                          .solid = on_panel(bevelled_frame(outline, half, bar, 1.6 * mm),
                                            slot_middle + (slot_depth - half) * Vector3d::UnitZ())});
  constexpr RadiusHeight screw[] = {{4.2 * mm, -sunk}, {4.2 * mm, 1.2 * mm}, {3.4 * mm, 2.0 * mm}};
  int number = 0;
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      model->parts.push_back(
          {.name = "slot/screw/" + std::to_string(++number),
           .material = steel,
           .solid = on_panel(lathe(screw, 32),
                             slot_middle + Vector3d(x * (a - 7 * mm), y * (b - 7 * mm), slot_depth))});
}

// A cushion in a steel rim.
void add_pad(Model* model) {
  constexpr double radius = 36.0 * mm, edge = 9.0 * mm;
  std::vector<RadiusHeight> cushion{{radius - 2.0 * mm, -sunk}, {radius, 2.0 * mm}, {radius, edge}};
  // From the edge to the top on an ellipse.
  for (int k = 1; k < 24; ++k) {
    const double angle = 0.5 * pi * k / 24;
    cushion.push_back({radius * math::cos(angle), edge + (pad_height - edge) * math::sin(angle)});
  }
  model->parts.push_back({.name = "pad/cushion",
                          .material = rubber,
                          .solid = on_panel(lathe(cushion, 80), pad_middle),
                          .crease = 60 * degree});
  constexpr RadiusHeight rim[] = {{radius - 3 * mm, -sunk},      {radius + 5 * mm, -sunk},
                                  {radius + 5 * mm, 6 * mm},     {radius + 4 * mm, 7 * mm},
                                  {radius + 1.5 * mm, 7.4 * mm}, {radius - 3 * mm, 6.4 * mm}};
  model->parts.push_back(
      {.name = "pad/rim", .material = steel, .solid = on_panel(lathe_ring(rim, 80), pad_middle)});
}

// Waves across the panel's y, between level ends.
void add_ridges(Model* model) {
  constexpr double bevel = 1.5 * mm, level = 7.0 * mm, step = 0.7 * mm;
  const double waves = 0.5 * ridge_pitch * ridge_count;  // half of their length
  const double half = waves + level;
  const auto height = [&](double y) {
    if (std::abs(y) >= waves) return ridges_base;
    return ridges_base + 0.5 * ridge_height * (1.0 - math::cos(2.0 * pi * (y + waves) / ridge_pitch));
  };
  const auto section = [&](double y, double inset) {
    const double w = ridges_half_width - inset, top = height(y) - inset;
    return Section{{-w, y, -sunk},      {-w, y, top - bevel}, {-w + bevel, y, top},
                   {w - bevel, y, top}, {w, y, top - bevel},  {w, y, -sunk}};
  };
  std::vector<Section> sections{section(-half, bevel)};
  const int pieces = static_cast<int>(std::ceil(2.0 * (half - bevel) / step));
  for (int k = 0; k <= pieces; ++k)
    sections.push_back(section(-half + bevel + 2.0 * (half - bevel) * k / pieces, 0.0));
  sections.push_back(section(half, bevel));
  model->parts.push_back({.name = "ridges",
                          .material = brass,
                          .solid = on_panel(loft(sections), ridges_middle),
                          .crease = 30 * degree});
}

// A button as machines have it to be stopped by: a red mushroom on a yellow box.
void add_button(Model* model) {
  const Vector3d half(32.0 * mm, 34.0 * mm, 0.5 * (18.0 * mm + sunk));
  model->parts.push_back({.name = "button/box",
                          .material = yellow,
                          .solid = on_panel(chamfered_box(half, 2.2 * mm),
                                            button_middle + (18.0 * mm - half.z()) * Vector3d::UnitZ())});
  constexpr RadiusHeight collar[] = {{17 * mm, 17.5 * mm},
                                     {17 * mm, 19.4 * mm},
                                     {16 * mm, 20.4 * mm},
                                     {11 * mm, 21 * mm},
                                     {11 * mm, 28 * mm}};
  model->parts.push_back(
      {.name = "button/collar", .material = slate, .solid = on_panel(lathe(collar, 64), button_middle)});
  std::vector<RadiusHeight> cap{
      {10.5 * mm, 26.5 * mm}, {20.0 * mm, 27.5 * mm}, {21.5 * mm, 29.5 * mm}, {21.5 * mm, 33.0 * mm}};
  for (int k = 1; k < 16; ++k) {
    const double angle = 0.5 * pi * k / 16;
    cap.push_back({21.5 * mm * math::cos(angle), 33.0 * mm + (button_height - 33.0 * mm) * math::sin(angle)});
  }
  model->parts.push_back({.name = "button/cap",
                          .material = red,
                          .solid = on_panel(lathe(cap, 72), button_middle),
                          .crease = 60 * degree});
}

}  // namespace

Isometry3d panel_in_world() {
  return Isometry3d(turn_by(-panel_lean, Vector3d::UnitX()));
}

Model make_stations() {
  Model model{.name = "stations",
              .materials =
                  {{.name = "steel", .base_colour = {0.56, 0.56, 0.57}, .metallic = 1.0, .roughness = 0.28},
                   {.name = "slate", .base_colour = {0.045, 0.055, 0.07}, .metallic = 0.0, .roughness = 0.45},
                   {.name = "rubber", .base_colour = {0.03, 0.22, 0.19}, .metallic = 0.0, .roughness = 0.75},
                   {.name = "brass", .base_colour = {0.83, 0.60, 0.26}, .metallic = 1.0, .roughness = 0.32},
                   {.name = "yellow", .base_colour = {0.80, 0.52, 0.03}, .metallic = 0.0, .roughness = 0.45},
                   {.name = "red", .base_colour = {0.62, 0.025, 0.02}, .metallic = 0.0, .roughness = 0.30}},
              .parts = {}};
  add_panel(&model);
  add_hoop(&model);
  add_slot(&model);
  add_pad(&model);
  add_ridges(&model);
  add_button(&model);
  return model;
}

}  // namespace fulcrum::content
