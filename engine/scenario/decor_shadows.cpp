#include "engine/scenario/decor_shadows.h"

#include <algorithm>
#include <utility>
#include <vector>

#include "engine/render/bounds.h"
#include "engine/render/light_fit.h"
#include "engine/render/look.h"

namespace fulcrum::scenario {
namespace {

constexpr float kWidest = 1.1F;  // what the shadow map may become, of what it is without decor

bool holds(const render::Bounds& box, const glm::vec3& place) {
  return glm::all(glm::lessThanEqual(box.low, place)) && glm::all(glm::lessThanEqual(place, box.high));
}

}  // namespace

void let_decor_throw_shadows(render::VisualDesc& desc, const render::KeyLight& light) {
  const bool is_spot = light.kind == render::KeyLight::Kind::spot;
  std::vector<render::Bounds> casters;  // that stand
  std::vector<std::pair<render::Bounds, render::Instance*>> decor;
  for (render::Instance& instance : desc.instances) {
    if (instance.movable) continue;
    const render::Bounds box =
        render::transformed(render::bounds_of(desc.meshes[instance.mesh].positions), instance.X_WM);
    render::Instance thrower = instance;
    thrower.casts_shadow = true;
    if (!render::throws_shadow(thrower, desc.materials[instance.material])) continue;
    if (instance.casts_shadow)
      casters.push_back(box);
    else if (!(is_spot && holds(box, light.position)))
      decor.emplace_back(box, &instance);
  }
  if (casters.empty()) return;
  const float widest = kWidest * render::width_seen(light, casters);
  // The smallest first, so that what comes of it does not depend on the order of the models.
  std::ranges::stable_sort(decor, {}, [&](const auto& each) {
    return render::width_seen(light, {&each.first, 1});
  });
  for (const auto& [box, instance] : decor) {
    casters.push_back(box);
    instance->casts_shadow = render::width_seen(light, casters) <= widest;
    if (!instance->casts_shadow) casters.pop_back();
  }
}

}  // namespace fulcrum::scenario
