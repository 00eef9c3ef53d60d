#include "engine/scenario/level_bars.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <string>
#include <utility>

#include "engine/render/turned.h"
#include "engine/scenario/followed.h"
#include "engine/scenario/to_glm.h"
#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"

namespace fulcrum::scenario {

namespace {

constexpr float kHeight = 0.03F;    // m, of a bar at its strongest
constexpr float kRadius = 0.0026F;  // m, of every bar
constexpr float kAside = 0.024F;    // m, from the finger's middle
constexpr float kFoot = 0.0018F;    // m, over what is touched
constexpr float kMin = 1e-5F;       // m: a transform must not flatten

void add(render::VisualDesc& desc, render::Mesh&& mesh, std::size_t material, std::size_t follows,
         std::uint32_t layers) {
  render::Instance instance;
  instance.mesh = desc.meshes.size();
  instance.material = material;
  instance.name = mesh.name;
  instance.movable = true;
  instance.casts_shadow = false;
  instance.layers = layers;
  instance.follows = follows;
  desc.meshes.push_back(std::move(mesh));
  desc.instances.push_back(std::move(instance));
}

void add_disc(render::Mesh& mesh, const glm::vec3& foot, float radius, float thick) {
  const render::Turned profile[] = {{0.0F, 0.0F}, {radius, 0.0F}, {radius, thick}, {0.0F, thick}};
  render::add_turned(mesh, foot, {0.0F, 1.0F, 0.0F}, profile);
}

}  // namespace

void add_level_bars(render::VisualDesc& desc, std::uint32_t layers) {
  const std::size_t rod = desc.materials.size(), bar = rod + 1;
  desc.materials.push_back({"level rod", {0.62F, 0.64F, 0.66F}, 0.0F, 0.4F});
  desc.materials.push_back({"level", {1.0F, 0.24F, 0.01F}, 0.0F, 0.5F});
  for (const float side : {-1.0F, 1.0F}) {
    const glm::vec3 foot{side * kAside, kFoot, 0.0F}, up{0.0F, 1.0F, 0.0F};
    render::Mesh frame, level;
    frame.name = level.name = side < 0 ? "level/left" : "level/right";
    add_disc(frame, foot - 0.0012F * up, 1.6F * kRadius, 0.0012F);
    render::add_bar(frame, foot, foot + kHeight * up, 0.0006F, 0.0006F);
    for (int quarter = 1; quarter <= 4; ++quarter)
      add_disc(frame, foot + 0.25F * static_cast<float>(quarter) * kHeight * up, 1.15F * kRadius,
               quarter == 4 ? 0.0008F : 0.0003F);
    add_disc(level, {}, kRadius, 1.0F);
    add(desc, std::move(frame), rod, kFollowsLevelFrame, layers);
    add(desc, std::move(level), bar, side < 0 ? kFollowsLeftLevel : kFollowsRightLevel, layers);
  }
}

Quat level_turn(const Vec3& axis_W) {
  const double along = math::hypot(axis_W.x(), axis_W.z());
  if (along < 1e-3 * axis_W.norm()) return Quat::Identity();  // it goes up or down: no side is the right one
  return turn_by(math::atan2(-axis_W.z(), axis_W.x()), Vec3::UnitY());
}

glm::mat4 level_pose(const Pose& X_WF, int side, double level) {
  glm::mat4 X = to_glm(X_WF);
  X[3] = X * glm::vec4(static_cast<float>(side) * kAside, kFoot, 0.0F, 1.0F);
  X[1] *= std::max(kMin, kHeight * static_cast<float>(std::clamp(level, 0.0, 1.0)));
  return X;
}

}  // namespace fulcrum::scenario
