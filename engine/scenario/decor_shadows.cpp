#include "engine/scenario/decor_shadows.h"

#include <algorithm>
#include <optional>

#include "engine/render/bounds.h"

namespace fulcrum::scenario {
namespace {

constexpr float kMostGrowth = 1.1F;  // of the longest side of what throws shadows

render::Bounds box_of(const render::VisualDesc& desc, const render::Instance& instance) {
  return render::transformed(render::bounds_of(desc.meshes[instance.mesh].positions), instance.X_WM);
}

float longest(const render::Bounds& box) {
  const glm::vec3 size = box.high - box.low;
  return std::max({size.x, size.y, size.z});
}

}  // namespace

void let_decor_throw_shadows(render::VisualDesc& desc) {
  std::optional<render::Bounds> casters;
  for (const render::Instance& instance : desc.instances) {
    if (!instance.casts_shadow || instance.movable) continue;
    const render::Bounds box = box_of(desc, instance);
    casters = casters ? render::united(*casters, box) : box;
  }
  if (!casters) return;
  for (render::Instance& instance : desc.instances) {
    if (instance.casts_shadow) continue;
    const render::Bounds with_it = render::united(*casters, box_of(desc, instance));
    instance.casts_shadow = longest(with_it) <= kMostGrowth * longest(*casters);
  }
}

}  // namespace fulcrum::scenario
