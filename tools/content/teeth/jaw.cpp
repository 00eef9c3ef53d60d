#include "tools/content/teeth/jaw.h"

#include <algorithm>
#include <cstddef>
#include <string>
#include <utility>

#include "tools/content/mesh/surface_nets.h"
#include "tools/content/teeth/coat.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr double gum_cell = 0.36;    // mm, where the gum shows
constexpr double coarse_cell = 0.7;  // mm, deep down

Solid in_metres(Solid solid) {
  for (Vector3d& p : solid.points) p *= mm;
  return solid;
}

Solid tooth_solid(const Tooth& tooth) {
  const double cell = tooth.design.cell;
  const double side = 0.75 * std::max(tooth.half_width * 2.0, 9.0);
  const auto even = [&](double) { return cell; };
  const auto finer_upwards = [&](double z) { return z < 0.6 ? 2.0 * cell : cell; };
  const GridLines lines{grid_line(-side, side, even), grid_line(-side, side, even),
                        grid_line(tooth.design.body.low - 0.8, tooth.crown_length + 0.7, finer_upwards)};
  Solid solid = surface_nets([&](const Vector3d& p) { return tooth.design.distance(p); }, lines);
  for (Vector3d& p : solid.points) p = tooth.to_world(p);
  turn_outward(&solid);  // the frames of one side of the jaw mirror
  return solid;
}

Solid gum_solid(const Dentition& dentition, const Gum& gum) {
  Eigen::AlignedBox2d box;
  for (double along = -dentition.arch.end(); along <= dentition.arch.end(); along += 1.0)
    box.extend(dentition.arch.at(along).p);
  constexpr double around = 14.0;
  const auto even = [](double) { return gum_cell; };
  const auto finer_upwards = [](double y) { return y < -16.0 ? coarse_cell : gum_cell; };
  const GridLines lines{grid_line(box.min().x() - around, box.max().x() + around, even),
                        grid_line(Gum::base - 2.5, -1.0, finer_upwards),
                        grid_line(box.min().y() - around, box.max().y() + around, even)};
  return surface_nets([&](const Vector3d& p) { return gum.distance(p); }, lines);
}

}  // namespace

Model make_jaw(const Dentition& dentition) {
  const Gum gum(dentition);
  // The colours are those of the points: the materials multiply them by one.
  Model model{
      .name = "jaw",
      .materials = {{.name = "enamel", .base_colour = {1.0, 1.0, 1.0}, .metallic = 0.0, .roughness = 0.11},
                    {.name = "gum", .base_colour = {1.0, 1.0, 1.0}, .metallic = 0.0, .roughness = 0.27}},
      .parts = {}};
  for (std::size_t i = 0; i < dentition.teeth.size(); ++i) {
    const Tooth& tooth = dentition.teeth[i];
    Solid solid = tooth_solid(tooth);
    Coat coat = enamel_coat(dentition, gum, i, solid);
    model.parts.push_back({.name = "tooth/" + std::to_string(tooth.number),
                           .material = 0,
                           .solid = in_metres(std::move(solid)),
                           .coat = std::move(coat)});
  }
  Solid solid = gum_solid(dentition, gum);
  Coat coat = gum_coat(dentition, gum, solid);
  model.parts.push_back(
      {.name = "gum", .material = 1, .solid = in_metres(std::move(solid)), .coat = std::move(coat)});
  return model;
}

}  // namespace fulcrum::content
