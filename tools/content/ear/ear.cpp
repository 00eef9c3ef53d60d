#include "tools/content/ear/ear.h"

#include <utility>

#include "tools/content/ear/coat.h"
#include "tools/content/ear/gloss.h"
#include "tools/content/mesh/surface_nets.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr double canal_cell = 0.34;  // mm
constexpr double pinna_cell = 0.46;  // mm
constexpr double skin_cell = 1.1;    // mm
constexpr double cut_cell = 0.5;     // mm

Solid in_metres(Solid solid) {
  for (Vector3d& p : solid.points) p *= mm;
  return solid;
}

// Finest about the canal, fine about the pinna.
std::function<double(double)> cells(double canal_from, double canal_to, double pinna_from, double pinna_to,
                                    double plain) {
  return [=](double at) {
    if (at > canal_from && at < canal_to) return canal_cell;
    return at > pinna_from && at < pinna_to ? pinna_cell : plain;
  };
}

// `plain`: the size of the cells (mm) where there is nothing but smooth skin or the face of the cut.
Solid flesh_solid(const Implicit& body, double plain) {
  const GridLines lines{grid_line(-51.0, 37.0, cells(-7.5, 11.5, -33.0, 16.0, plain)),
                        grid_line(-46.0, 54.0, cells(-10.0, 9.0, -29.0, 41.0, plain)),
                        grid_line(Flesh::back - 2.5, 25.0, cells(-31.5, 2.0, 1.0, 25.0, plain))};
  return surface_nets(body, lines);
}

Solid drum_solid(const Flesh& flesh, double rim) {
  const auto even = [](double) { return 0.2; };
  const Vector3d m = flesh.canal().X_WD().translation();
  const GridLines lines{grid_line(m.x() - 8.0, m.x() + 8.0, even), grid_line(m.y() - 8.0, m.y() + 8.0, even),
                        grid_line(m.z() - 7.5, m.z() + 7.0, even)};
  return surface_nets([&](const Vector3d& p) { return flesh.to_membrane(p, rim); }, lines);
}

Model with_drum(const Flesh& flesh, const std::string& name, Solid solid, MoistCoat skin, double rim) {
  // The colours are those of the points: the materials multiply them by one.
  Model model{
      .name = name,
      .materials = {moist("skin"),
                    {.name = "drum", .base_colour = {1.0, 1.0, 1.0}, .metallic = 0.0, .roughness = 0.28}},
      .parts = {}};
  CornerUv uv = laid_by_wetness(solid, skin.wetness);
  model.parts.push_back({.name = name,
                         .material = 0,
                         .solid = in_metres(std::move(solid)),
                         .coat = std::move(skin.coat),
                         .uv = std::move(uv)});
  Solid drum = drum_solid(flesh, rim);
  Coat drum_colours = drum_coat(flesh, drum, rim);
  model.parts.push_back(
      {.name = "drum", .material = 1, .solid = in_metres(std::move(drum)), .coat = std::move(drum_colours)});
  return model;
}

}  // namespace

Model make_ear(const Flesh& flesh) {
  Solid solid = flesh_solid([&](const Vector3d& p) { return flesh.distance(p); }, skin_cell);
  MoistCoat skin = skin_coat(flesh, solid);
  return with_drum(flesh, "ear", std::move(solid), std::move(skin), Flesh::buried_rim);
}

Model make_open_ear(const Flesh& flesh) {
  Solid solid = flesh_solid([&](const Vector3d& p) { return flesh.open_distance(p); }, cut_cell);
  MoistCoat skin = open_coat(flesh, solid);
  return with_drum(flesh, "ear_open", std::move(solid), std::move(skin), Flesh::open_rim);
}

}  // namespace fulcrum::content
