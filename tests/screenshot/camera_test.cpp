// The orbit camera, the projection and the fit of the shadow map, in numbers.

#include <gtest/gtest.h>

#include <cmath>

#include "engine/render/frame_data.h"
#include "engine/render/orbit_camera.h"

namespace fulcrum::render {
namespace {

const Camera kStart{{0.3F, 0.4F, 0.5F}, {0.0F, 0.1F, 0.0F}, 0.7F};

glm::vec3 projected(const glm::mat4& clip_from_world, const glm::vec3& point) {
  const glm::vec4 clip = clip_from_world * glm::vec4(point, 1.0F);
  return glm::vec3(clip) / clip.w;
}

void expect_near(const glm::vec3& actual, const glm::vec3& expected) {
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(actual[i], expected[i], 1e-5F);
}

TEST(OrbitCamera, StartsWhereItIsToldAndReturns) {
  OrbitCamera orbit(kStart);
  expect_near(orbit.camera().eye, kStart.eye);
  orbit.orbit(0.2F, 0.1F);
  orbit.pan(0.1F, -0.3F);
  orbit.zoom(4.0F);
  orbit.reset();
  expect_near(orbit.camera().eye, kStart.eye);
  expect_near(orbit.camera().target, kStart.target);
}

TEST(OrbitCamera, TurningKeepsTheDistance) {
  OrbitCamera orbit(kStart);
  const float before = glm::length(kStart.eye - kStart.target);
  orbit.orbit(0.37F, -0.21F);
  EXPECT_NEAR(glm::length(orbit.camera().eye - orbit.camera().target), before, 1e-5F);
}

TEST(OrbitCamera, NeverTurnsOverTheTop) {
  OrbitCamera orbit(kStart);
  orbit.orbit(0.0F, 100.0F);
  const Camera above = orbit.camera();
  EXPECT_GT(std::hypot(above.eye.x - above.target.x, above.eye.z - above.target.z), 0.005F);
  EXPECT_GT(above.eye.y, above.target.y);
}

TEST(OrbitCamera, PanningMovesWhatIsAtTheTargetWithTheMouse) {
  OrbitCamera orbit(kStart);
  orbit.pan(0.25F, 0.1F);  // of the window's height: half of it is one unit of clip space
  const glm::vec3 at = projected(clip_from_world(orbit.camera(), {100, 100}), kStart.target);
  EXPECT_NEAR(at.x, 0.5F, 1e-4F);
  EXPECT_NEAR(at.y, -0.2F, 1e-4F);
}

TEST(OrbitCamera, ZoomStaysWithinItsLimits) {
  OrbitCamera orbit(kStart);
  orbit.zoom(1000.0F);
  EXPECT_NEAR(glm::length(orbit.camera().eye - orbit.camera().target), 0.02F, 1e-5F);
  orbit.zoom(-1000.0F);
  EXPECT_NEAR(glm::length(orbit.camera().eye - orbit.camera().target), 20.0F, 1e-3F);
}

// A scene of 2 mm, and one of 100 m.
TEST(OrbitCamera, StaysWithScenesOfAnySize) {
  for (const float size : {0.002F, 100.0F}) {
    const Camera start{{size, 0, 0}, {0, 0, 0}, 0.7F};
    OrbitCamera orbit(start);
    EXPECT_FLOAT_EQ(orbit.camera().eye.x, size);
    orbit.zoom(4.0F);
    orbit.zoom(-4.0F);
    EXPECT_NEAR(orbit.camera().eye.x, size, 1e-5F * size);
  }
}

TEST(Projection, DepthIsOneAtTheNearPlaneAndFallsToZero) {
  const Camera camera{{0.0F, 0.0F, 1.0F}, {0.0F, 0.0F, 0.0F}, 0.7F};
  const glm::mat4 clip = clip_from_world(camera, {1280, 720});
  EXPECT_NEAR(projected(clip, {0.0F, 0.0F, 1.0F - 0.005F}).z, 1.0F, 1e-5F);
  EXPECT_NEAR(projected(clip, {0.0F, 0.0F, -1e5F}).z, 0.0F, 1e-6F);
  EXPECT_GT(projected(clip, {0.0F, 0.1F, 0.0F}).y, 0.0F);  // up is up
}

// A part of 0.2 mm seen from 0.4 mm is not cut open.
TEST(Projection, SmallScenesAreNotCutOpen) {
  for (const float away : {0.0004F, 0.004F, 0.04F}) {
    const Camera camera{{0, 0, away}, {0, 0, 0}, 0.7F};
    const float near = nearest_seen(camera);
    EXPECT_LE(near, 0.051F * away);
    EXPECT_NEAR(projected(clip_from_world(camera, {64, 64}), {0, 0, away - near}).z, 1.0F, 1e-4F);
  }
  EXPECT_EQ(nearest_seen({{0, 0, 3}, {0, 0, 0}, 0.7F}), 0.005F);
}

TEST(Projection, LooksStraightDownWithoutTrouble) {
  const Camera camera{{0.0F, 1.0F, 0.0F}, {0.0F, 0.0F, 0.0F}, 0.7F};
  expect_near(projected(clip_from_world(camera, {100, 100}), camera.target), {0.0F, 0.0F, 0.005F});
}

TEST(LightFit, CoversEveryCasterAndLooksFromTheLight) {
  for (const KeyLight::Kind kind : {KeyLight::Kind::directional, KeyLight::Kind::spot}) {
    KeyLight light;
    light.kind = kind;
    light.position = {0.5F, 2.0F, 0.5F};
    light.direction = glm::vec3(0.0F) - light.position;
    const std::vector<Bounds> casters = {{{-0.3F, 0.0F, -0.1F}, {-0.1F, 0.4F, 0.1F}},
                                         {{0.1F, 0.0F, 0.0F}, {0.2F, 0.1F, 0.3F}}};
    const LightFit fit = fit_light(light, casters, 1024);
    for (const Bounds& box : casters) {
      for (const glm::vec3& corner : {box.low, box.high}) {
        const glm::vec3 at = projected(fit.clip_from_world, corner);
        EXPECT_LT(std::abs(at.x), 1.0F);
        EXPECT_LT(std::abs(at.y), 1.0F);
        EXPECT_GT(at.z, 0.0F);
        EXPECT_LT(at.z, 1.0F);
      }
    }
    const float above = projected(fit.clip_from_world, {0.0F, 0.2F, 0.0F}).z;
    const float below = projected(fit.clip_from_world, {0.0F, 0.0F, 0.0F}).z;
    EXPECT_LT(above, below);
  }
}

TEST(LightFit, IsKeptWhileItCoversWhatMovesAndIsNotFarTooCoarse) {
  const KeyLight light;
  const auto casters = [](float reach) {
    return std::vector<Bounds>{{{-0.5F, 0.0F, -0.5F}, {0.5F, 0.3F, 0.5F}},
                               {{-0.01F, 0.1F, reach}, {0.01F, 0.2F, reach + 0.1F}}};
  };
  const LightFit inside = fit_light(light, casters(0.0F), 1024),
                 outside = fit_light(light, casters(3.0F), 1024);
  EXPECT_TRUE(still_fits(inside, light, casters(0.2F), 1024));
  EXPECT_FALSE(still_fits(inside, light, casters(3.0F), 1024)) << "beyond its edge";
  EXPECT_TRUE(still_fits(outside, light, casters(2.9F), 1024));
  EXPECT_FALSE(still_fits(outside, light, casters(0.0F), 1024)) << "a much finer one would do";
}

// What is beside its cone or behind it is not in its map, and is no reason to draw what stands anew.
TEST(LightFit, OfASpotIsKeptWhateverIsBesideIt) {
  KeyLight light;
  light.kind = KeyLight::Kind::spot;
  light.position = {0.0F, 1.0F, 0.0F};
  light.direction = {0.0F, -1.0F, 0.0F};
  light.cone_rad = 0.8F;
  const auto casters = [](const glm::vec3& other) {
    return std::vector<Bounds>{{{-0.1F, 0.0F, -0.1F}, {0.1F, 0.3F, 0.1F}}, {other, other + glm::vec3(0.05F)}};
  };
  const glm::vec3 within(0.0F, 0.1F, 0.2F);
  const LightFit fit = fit_light(light, casters(within), 1024);
  for (const glm::vec3& other : {within, {3.0F, 0.2F, 0.0F}, {0.0F, 1.5F, 0.0F}, {5.0F, -9.0F, 0.0F}})
    EXPECT_TRUE(still_fits(fit, light, casters(other), 1024)) << other.x << " " << other.y;
  EXPECT_TRUE(still_fits(fit, light, casters({0.0F, -0.02F, 0.2F}), 1024)) << "a small move";
  EXPECT_FALSE(still_fits(fit, light, casters({0.0F, -1.0F, 0.0F}), 1024)) << "beyond what is farthest";
  EXPECT_FALSE(still_fits(fit, light, casters({0.0F, 0.6F, 0.0F}), 1024)) << "before what is nearest";
  EXPECT_EQ(fit_light(light, std::vector<Bounds>{{glm::vec3(2.0F), glm::vec3(3.0F)}}, 1024).texel, 0.0F);
}

TEST(LightFit, ASmallMoveOfACasterShiftsTheMapByWholeTexels) {
  KeyLight light;
  const glm::vec3 fixed{0.0F, 0.0F, 0.0F};
  const auto texel_of = [&](float move) {
    const std::vector<Bounds> casters = {{{-0.5F, 0.0F, -0.5F}, {0.5F + move, 0.3F, 0.5F}}};
    return 512.0F * projected(fit_light(light, casters, 1024).clip_from_world, fixed);
  };
  const glm::vec3 before = texel_of(0.0F);
  const glm::vec3 after = texel_of(0.013F);
  EXPECT_NEAR(after.x - before.x, std::round(after.x - before.x), 0.01F);
  EXPECT_NEAR(after.y - before.y, std::round(after.y - before.y), 0.01F);
}

}  // namespace
}  // namespace fulcrum::render
