#include "engine/app/edit/handles.h"

#include <algorithm>
#include <utility>

#include "engine/scenario/assemble.h"
#include "engine/scenario/words.h"

namespace fulcrum::app {
namespace {

std::vector<double> three_numbers(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}

Vec3 widened(const glm::vec3& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

Pose model_pose(const Prepared& prepared, const Pose& X_WT) {
  return X_WT * Pose{Quat::Identity(), -prepared.models.p_MT};
}

// A light is turned about what it lights, at the distance of the first view's eye from its target.
struct LightArm {
  Vec3 p_W;    // the light's end of it
  Vec3 lit_W;  // the other
};

LightArm light_arm(const Prepared& prepared) {
  const render::KeyLight& light = *prepared.scenario.light;
  const auto& views = prepared.scenario.views;
  const render::Camera camera = views.empty() ? render::Camera() : views.front().camera;
  const Vec3 target = widened(camera.target), along = widened(light.direction).stableNormalized();
  const double length = (widened(camera.eye) - target).norm();
  if (light.kind != render::KeyLight::Kind::spot) return {target - length * along, target};
  const Vec3 place = widened(light.position);
  return {place, place + std::max((target - place).norm(), 1e-3) * along};
}

std::string of_checkpoint(const scenario::Checkpoint& checkpoint) {
  return "checkpoints." + std::to_string(checkpoint.written);
}

void add_task(const scenario::Scenario& scenario, std::vector<Handle>& all) {
  using Kind = Handle::Kind;
  for (std::size_t i = 0; i < scenario.checkpoints.size(); ++i) {
    const scenario::Checkpoint& checkpoint = scenario.checkpoints[i];
    all.push_back({Kind::checkpoint, i, 0, checkpoint.name, checkpoint.position, checkpoint.radius});
    for (std::size_t k = 0; k < checkpoint.follow.size(); ++k) {
      std::string name = checkpoint.name;
      name.append(", corner ").append(std::to_string(k + 1));
      all.push_back({Kind::corner, i, k, std::move(name), checkpoint.follow[k]});
    }
  }
  for (std::size_t i = 0; i < scenario.avoid.size(); ++i)
    all.push_back(
        {Kind::ball, i, 0, scenario.avoid[i].name, scenario.avoid[i].position, scenario.avoid[i].radius});
}

}  // namespace

std::vector<Handle> handles_of(const Prepared& prepared, const Pose& X_WT) {
  using Kind = Handle::Kind;
  const scenario::Scenario& scenario = prepared.scenario;
  std::vector<Handle> all;
  add_task(scenario, all);
  all.push_back({Kind::start, 0, 0, "start", scenario.tool.X_WM_start * scenario.tool.touch_point});
  const Pose X_WH = model_pose(prepared, X_WT) * scenario.tool.X_HM.inverse();
  all.push_back({Kind::grasp, 0, 0, "grasp", X_WH.p});
  for (std::size_t i = 0; i < scenario.views.size(); ++i) {
    const scenario::View& view = scenario.views[i];
    all.push_back({Kind::eye, i, 0, "view " + view.name + ": eye", widened(view.camera.eye)});
    all.push_back({Kind::target, i, 0, "view " + view.name + ": target", widened(view.camera.target)});
  }
  if (scenario.light) all.push_back({Kind::light, 0, 0, "light", light_arm(prepared).p_W});
  return all;
}

std::vector<scenario::NumberChange> put_at(const Prepared& prepared, const Pose& X_WT, const Handle& handle,
                                           const Vec3& p_W) {
  const scenario::Scenario& scenario = prepared.scenario;
  const std::string index = std::to_string(handle.index);
  switch (handle.kind) {
    case Handle::Kind::checkpoint:
      return {{of_checkpoint(scenario.checkpoints[handle.index]) + ".position", three_numbers(p_W)}};
    case Handle::Kind::corner: {
      std::string path = of_checkpoint(scenario.checkpoints[handle.index]);
      path.append(".follow.").append(std::to_string(handle.corner)).append(".corner");
      return {{std::move(path), three_numbers(p_W)}};
    }
    case Handle::Kind::ball:
      return {{"avoid." + index + ".position", three_numbers(p_W)}};
    case Handle::Kind::start: {
      const Pose& X_WM = scenario.tool.X_WM_start;
      return {{"tool.start.position", three_numbers(p_W - X_WM.q * scenario.tool.touch_point)}};
    }
    case Handle::Kind::grasp: {  // the model's pose in the handle, whose origin is to be at that place
      const Vec3 p_M = model_pose(prepared, X_WT).inverse() * p_W;
      return {{"tool.grasp.position", three_numbers(-(scenario.tool.X_HM.q * p_M))}};
    }
    case Handle::Kind::eye:
      return {{"views." + index + ".eye", three_numbers(p_W)}};
    case Handle::Kind::target:
      return {{"views." + index + ".target", three_numbers(p_W)}};
    case Handle::Kind::light: {
      const Vec3 direction = (light_arm(prepared).lit_W - p_W).stableNormalized();
      std::vector<scenario::NumberChange> changes{{"light.direction", three_numbers(direction)}};
      if (scenario.light->kind == render::KeyLight::Kind::spot)
        changes.push_back({"light.position", three_numbers(p_W)});
      return changes;
    }
  }
  return {};
}

}  // namespace fulcrum::app
