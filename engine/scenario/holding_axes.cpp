#include "engine/scenario/holding_axes.h"

#include <string>
#include <utility>

#include "engine/render/turned.h"
#include "engine/scenario/followed.h"

namespace fulcrum::scenario {

namespace {

constexpr float kLength = 0.036F, kShaft = 0.72F;      // m; the head's part is the rest
constexpr float kThin = 0.0014F, kThinHead = 0.0036F;  // m, radii
constexpr float kCollar = 0.0052F, kCollarHead = 0.0070F,
                kCollarLength = 0.0025F;  // m, of that about the stick

render::Mesh arrow(const glm::vec3& axis) {
  const render::Turned profile[] = {
      {0.0F, 0.0F}, {kThin, 0.0F}, {kThin, kShaft * kLength}, {kThinHead, kShaft * kLength}, {0.0F, kLength}};
  render::Mesh mesh;
  render::add_turned(mesh, {}, axis, profile);
  return mesh;
}

// The stick is this arrow's shaft, so that the scale on it stays in sight.
render::Mesh arrow_about_stick(const glm::vec3& axis) {
  const render::Turned collar[] = {{0.0F, -0.5F * kCollarLength},
                                   {kCollar, -0.5F * kCollarLength},
                                   {kCollar, 0.5F * kCollarLength},
                                   {0.0F, 0.5F * kCollarLength}};
  const render::Turned head[] = {{0.0F, kShaft * kLength}, {kCollarHead, kShaft * kLength}, {0.0F, kLength}};
  render::Mesh mesh;
  render::add_turned(mesh, {}, axis, collar);
  render::add_turned(mesh, {}, axis, head);
  return mesh;
}

}  // namespace

void add_holding_axes(render::VisualDesc& desc, std::uint32_t layers) {
  const glm::vec3 colours[] = {{0.80F, 0.02F, 0.02F}, {0.03F, 0.48F, 0.05F}, {0.02F, 0.10F, 0.85F}};
  for (int axis = 0; axis < 3; ++axis) {
    glm::vec3 along(0.0F);
    along[axis] = 1.0F;
    render::Mesh mesh = axis == 0 ? arrow_about_stick(along) : arrow(along);
    mesh.name = std::string("holding point/") + "xyz"[axis];
    render::Instance instance;
    instance.mesh = desc.meshes.size();
    instance.material = desc.materials.size();
    instance.name = mesh.name;
    instance.movable = true;
    instance.casts_shadow = false;  // an arrow only marks a place
    instance.layers = layers;
    instance.follows = kFollowsHoldingPoint;
    desc.materials.push_back({mesh.name, colours[axis], 0.0F, 0.4F});
    desc.meshes.push_back(std::move(mesh));
    desc.instances.push_back(std::move(instance));
  }
}

}  // namespace fulcrum::scenario
