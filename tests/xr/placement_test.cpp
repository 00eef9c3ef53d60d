#include "engine/headset/placement.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/render/frame_data.h"
#include "engine/scenario/to_glm.h"
#include "haptics/device/mapping.h"
#include "haptics/math/rotation.h"

namespace fulcrum::headset {
namespace {

render::Camera view(const glm::vec3& eye, const glm::vec3& target) {
  render::Camera camera;
  camera.eye = eye;
  camera.target = target;
  return camera;
}

const render::Camera kFar = view({0.4F, 0.3F, 0.95F}, {0, 0, 0.03F});
const render::Camera kNear = view({0, 0.02F, 0.14F}, {0, -0.009F, 0});

Vec3 in_L(const Placement& placement, const glm::vec3& p_W) {
  const Vec3 p(static_cast<double>(p_W.x), static_cast<double>(p_W.y), static_cast<double>(p_W.z));
  return placement.scale * (placement.X_WL.inverse() * p);
}

TEST(Placement, LocalHeadBeginsAtTheViewsEyeAndFloorStaysLevel) {
  const Placement placement = place_scene(kFar, {});
  EXPECT_LT(in_L(placement, kFar.eye).norm(), 1e-6);
  EXPECT_LT((placement.X_WL.q * Vec3::UnitY() - Vec3::UnitY()).norm(), 1e-12);
  const Vec3 target_L = in_L(placement, kFar.target);
  EXPECT_NEAR(target_L.x(), 0, 1e-6);
  EXPECT_NEAR(target_L.y(), -0.3, 1e-6);
  EXPECT_NEAR(target_L.z(), -std::hypot(0.4, 0.92), 1e-6);
}

TEST(Placement, NothingIsNearerThanIsComfortable) {
  const Vec3 target_L = in_L(place_scene(kNear, {}), kNear.target);
  EXPECT_NEAR(target_L.norm(), kNearest, 1e-6);
  EXPECT_NEAR(target_L.y() / target_L.z(), 0.029 / 0.14, 1e-6);  // on the view's own line
}

TEST(Placement, ScaleEnlargesAboutTheTarget) {
  app::HeadsetOptions options;
  options.scale = 5;
  const Placement placement = place_scene(kNear, options);
  const Vec3 target_L = in_L(placement, kNear.target);
  EXPECT_NEAR(target_L.norm(), 5 * std::hypot(0.029, 0.14), 1e-6);
  EXPECT_NEAR((in_L(placement, kNear.target + glm::vec3(0.01F, 0, 0)) - target_L).norm(), 0.05, 1e-6);
}

TEST(Placement, StageHasTheTargetOverItsMiddle) {
  app::HeadsetOptions options;
  options.space = app::kStageSpace;
  options.scale = 2;
  const Vec3 target_L = in_L(place_scene(kFar, options), kFar.target);
  EXPECT_LT((target_L - Vec3(0, kBench, 0)).norm(), 1e-6);
}

TEST(Placement, ViewFromStraightAboveIsNotTurned) {
  const Placement placement = place_scene(view({0, 1, 0}, {0, 0, 0}), {});
  EXPECT_LT(angle_of(placement.X_WL.q), 1e-12);
}

// What the handle is at in the scene is seen where the handle is in the headset's space, and as large.
TEST(Placement, OnADeviceWhatIsSeenStandsWhereItIsFelt) {
  MappingDesc mapping;
  mapping.X_WD = {turn_by(-0.4, Vec3(0, 1, 0)), Vec3(0.1, 0.06, 0.2)};
  mapping.position_scale = 2.5;
  const Pose X_LD{turn_by(1.1, Vec3(1, 9, 2).normalized()), Vec3(0.3, 0.8, -0.5)};
  const Placement placement = place_on_device(mapping.X_WD, mapping.position_scale, X_LD);
  for (const Vec3& p_D : {Vec3(0, 0, 0), Vec3(0.08, -0.03, 0.01), Vec3(-0.02, 0.05, 0.07)}) {
    const Pose X_DH{turn_by(0.6, Vec3(3, 1, 2).normalized()), p_D};
    const Pose seen = placement.in_world(X_LD * X_DH), is = mapping.handle_in_world(X_DH);
    EXPECT_LT((seen.p - is.p).norm(), 1e-12);
    EXPECT_LT(angle_of(seen.q * is.q.conjugate()), 1e-12);
  }
}

// Where a frustum of OpenXR has its edges, a camera has the edges of its picture: also with a rolled head.
TEST(EyeCamera, EdgesOfTheFieldOfViewAreThoseOfThePicture) {
  app::HeadsetOptions options;
  options.scale = 3;
  const Placement placement = place_scene(kFar, options);
  const XrFovf fov{-0.9F, 0.7F, 0.8F, -0.6F};
  const Pose X_LE{turn_by(0.4, Vec3(1, 2, 3).normalized()), Vec3(0.1, -0.2, 0.3)};
  const render::Camera camera = eye_camera({X_LE, fov}, placement, 1);
  const glm::mat4 clip = render::clip_from_world(camera, {320, 240});
  for (const float x : {fov.angleLeft, fov.angleRight})
    for (const float y : {fov.angleUp, fov.angleDown}) {
      const Vec3 corner_E(std::tan(static_cast<double>(x)), std::tan(static_cast<double>(y)), -1);
      const Pose X_WC = placement.in_world(X_LE * Pose{Quat::Identity(), corner_E});
      const glm::vec4 at = clip * glm::vec4(scenario::narrowed(X_WC.p), 1.0F);
      EXPECT_NEAR(at.x / at.w, x < 0 ? -1 : 1, 1e-5);
      EXPECT_NEAR(at.y / at.w, y < 0 ? -1 : 1, 1e-5);
    }
}

// Who puts the head to an enlarged part looks at it, and not through it.
TEST(EyeCamera, NothingIsCutOpenBeyondFiveCentimetresHoweverLargeTheSceneIs) {
  for (const double scale : {0.1, 1.0, 10.0, 100.0}) {
    app::HeadsetOptions options;
    options.scale = scale;
    const Placement placement = place_scene(kNear, options);
    const Pose X_LE{turn_by(0.4, Vec3(1, 2, 3).normalized()), Vec3(0.1, -0.2, 0.3)};
    const render::Camera camera = eye_camera({X_LE, {-0.9F, 0.9F, 0.9F, -0.9F}}, placement, 1);
    const glm::mat4 clip = render::clip_from_world(camera, {320, 240});
    const Pose X_WC = placement.in_world(X_LE * Pose{Quat::Identity(), Vec3(0, 0, -0.051)});
    const glm::vec4 at = clip * glm::vec4(scenario::narrowed(X_WC.p), 1.0F);
    EXPECT_GT(at.w, 0.0F) << scale;
    EXPECT_LT(at.z, at.w) << scale;  // depth 1 is the near plane's
  }
}

}  // namespace
}  // namespace fulcrum::headset
