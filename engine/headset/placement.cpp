#include "engine/headset/placement.h"

#include <algorithm>

#include "engine/scenario/to_glm.h"
#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"

namespace fulcrum::headset {
namespace {

Vec3 widened(const glm::vec3& v) {
  return {static_cast<double>(v.x), static_cast<double>(v.y), static_cast<double>(v.z)};
}

}  // namespace

Quat heading(const Vec3& ahead) {
  if (ahead.x() * ahead.x() + ahead.z() * ahead.z() < 1e-6) return Quat::Identity();
  return turn_by(math::atan2(-ahead.x(), -ahead.z()), Vec3::UnitY());
}

Placement place_scene(const render::Camera& view, const app::HeadsetOptions& options) {
  const Vec3 target_W = widened(view.target), eye_W = widened(view.eye);
  const Vec3 ahead = (target_W - eye_W).normalized();
  Placement placement{{heading(ahead), Vec3::Zero()}, options.scale};
  if (options.space == app::kStageSpace) {
    placement.X_WL.p = target_W - Vec3(0, kBench / options.scale, 0);
  } else {
    const double away = std::max((target_W - eye_W).norm() * options.scale, kNearest);  // m in L
    placement.X_WL.p = target_W - ahead * (away / options.scale);
  }
  return placement;
}

Placement place_on_device(const Pose& X_WD, double position_scale, const Pose& X_LD) {
  const Quat q_WL = X_WD.q * X_LD.q.conjugate();
  return {{q_WL, X_WD.p - q_WL * (position_scale * X_LD.p)}, 1 / position_scale};
}

render::Camera eye_camera(const xr::EyeView& eye, const Placement& placement, std::uint32_t layers) {
  const Pose X_WE = placement.in_world(eye.X_LE);
  const auto tangent = [](float angle) { return static_cast<float>(math::tan(static_cast<double>(angle))); };
  const float left = tangent(eye.fov.angleLeft), right = tangent(eye.fov.angleRight);
  const float up = tangent(eye.fov.angleUp), down = tangent(eye.fov.angleDown);
  render::Camera camera;
  camera.eye = scenario::narrowed(X_WE.p);
  camera.target = scenario::narrowed(X_WE * Vec3(0, 0, -1 / placement.scale));  // 1 m away in L
  camera.up = scenario::narrowed(X_WE.q * Vec3::UnitY());
  camera.vertical_fov_rad =
      2.0F * static_cast<float>(math::atan2(static_cast<double>(0.5F * (up - down)), 1.0));
  camera.aspect = (right - left) / (up - down);
  camera.lean = 0.5F * glm::vec2(left + right, up + down);
  camera.layers = layers;
  return camera;
}

}  // namespace fulcrum::headset
