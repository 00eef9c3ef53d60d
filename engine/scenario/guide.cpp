#include "engine/scenario/guide.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/render/turned.h"
#include "engine/scenario/followed.h"
#include "engine/scenario/to_glm.h"

namespace fulcrum::scenario {

namespace {

constexpr double kPeak = 1.875;  // of the speed in the middle of a way of least jerk to its mean

}  // namespace

Vec3 guide_place(const GuideDesc& guide, double time) {
  const double way = kPeak * (guide.to_W - guide.from_W).norm() / guide.speed;  // s
  const double leg = way + guide.rest;
  const double in_round = std::fmod(std::max(time - guide.wait, 0.0), 2 * leg);
  const bool back = in_round >= leg;
  const double s = std::clamp((in_round - (back ? leg : 0)) / way, 0.0, 1.0);
  const double part = s * s * s * (10 + s * (6 * s - 15));
  return guide.from_W + (back ? 1 - part : part) * (guide.to_W - guide.from_W);
}

void add_guide(render::VisualDesc& desc, const GuideDesc& guide, std::uint32_t layers) {
  render::Mesh mesh;
  mesh.name = "guide";
  render::add_ball(mesh, {}, static_cast<float>(guide.radius));
  render::Instance instance;
  instance.mesh = desc.meshes.size();
  instance.material = desc.materials.size();
  instance.name = "guide";
  instance.X_WM = to_glm({Quat::Identity(), guide.from_W});
  instance.movable = true;
  instance.layers = layers;
  instance.follows = kFollowsGuide;
  desc.materials.push_back({"guide", {1.0F, 0.72F, 0.05F}, 0.0F, 0.35F});
  desc.meshes.push_back(std::move(mesh));
  desc.instances.push_back(std::move(instance));
}

}  // namespace fulcrum::scenario
