#pragma once
// A light that a model's file brings: a point of no size, or light from infinitely far away, as glTF's
// KHR_lights_punctual says it (registry.khronos.org/glTF).

#include <array>
#include <numbers>
#include <optional>
#include <string>

#include "haptics/math/linear.h"

namespace fulcrum {

struct ModelLight {
  enum class Kind { directional, point, spot };
  std::string name;
  Kind kind = Kind::point;
  std::array<float, 3> colour{1, 1, 1};      // linear RGB
  double intensity = 1;                      // cd; of a directional one lx
  std::optional<double> range;               // m, where it ends; none: nowhere
  double inner_cone = 0;                     // rad, from a spot's axis: where it begins to fade
  double outer_cone = std::numbers::pi / 4;  // and where it ends
  Vec3 position_M = Vec3::Zero();            // (3) m, node transforms applied
  Vec3 direction_M = -Vec3::UnitZ();         // (3) unit, as the light travels
  // What the file's author has marked its object with, as of a ModelPart.
  std::string marked_role;
  std::string marked_material;
};

}  // namespace fulcrum
