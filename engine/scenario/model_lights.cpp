#include "engine/scenario/model_lights.h"

#include <cmath>
#include <numbers>

#include "engine/scenario/to_glm.h"
#include "haptics/math/functions.h"

namespace fulcrum::scenario {
namespace {

// As Blender exports its watts, so that lights keep the measure that they have there to its pictures of the
// surroundings: radiance 1 is 1 W / (sr m^2), and 683 lm are a watt, as of the green that eyes see best (SI
// Brochure, 9th edition, 2.3.5).
constexpr double kLumensOfAWatt = 683;

render::PunctualLight::Kind kind_of(ModelLight::Kind kind) {
  switch (kind) {
    case ModelLight::Kind::directional:
      return render::PunctualLight::Kind::directional;
    case ModelLight::Kind::spot:
      return render::PunctualLight::Kind::spot;
    default:
      return render::PunctualLight::Kind::point;
  }
}

}  // namespace

void transform(std::vector<ModelLight>& lights, const Eigen::Affine3d& X) {
  const double scale = math::cbrt(std::abs(X.linear().determinant()));
  for (ModelLight& light : lights) {
    light.position_M = X * light.position_M;
    light.direction_M = (X.linear() * light.direction_M).stableNormalized();
    if (light.range) *light.range *= scale;
    if (light.kind != ModelLight::Kind::directional) light.intensity *= scale * scale;
  }
}

bool can_be_drawn(const ModelLight& light) {
  constexpr double kBrightest = 1e9, kNearestEnd = 1e-6;  // cd or lx; m
  return light.intensity <= kBrightest && light.range.value_or(1.0) >= kNearestEnd;
}

void add_lights(render::VisualDesc& desc, const std::vector<ModelLight>& lights, const Vec3& origin,
                std::optional<std::size_t> carried_by, std::uint32_t layers) {
  for (const ModelLight& light : lights) {
    render::PunctualLight drawn;
    drawn.name = light.name;
    drawn.kind = kind_of(light.kind);
    drawn.position = narrowed(light.position_M - origin);
    drawn.direction = narrowed(light.direction_M);
    drawn.colour = {light.colour[0], light.colour[1], light.colour[2]};
    drawn.intensity = static_cast<float>(light.intensity / (kLumensOfAWatt * std::numbers::pi));
    if (light.range) drawn.range = static_cast<float>(*light.range);
    drawn.inner_cone_rad = static_cast<float>(light.inner_cone);
    drawn.outer_cone_rad = static_cast<float>(light.outer_cone);
    drawn.carried_by = carried_by;
    drawn.layers = layers;
    desc.lights.push_back(std::move(drawn));
  }
}

}  // namespace fulcrum::scenario
