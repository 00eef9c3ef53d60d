// What each of two eyes sees, in numbers: against the theory of a sheared frustum and of a window into a
// scene.

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "engine/render/frame_data.h"
#include "engine/render/stereo.h"

namespace fulcrum::render {
namespace {

constexpr Extent kWindow{1280, 720};
const Camera kAhead{{0.0F, 0.1F, 0.5F}, {0.0F, 0.1F, 0.0F}, 0.7F};  // looks along -z
const Stereo kNoScreen{};

// px, from the top left.
glm::vec2 pixel_of(const Camera& camera, const glm::vec3& p_W) {
  const glm::vec4 clip = clip_from_world(camera, kWindow) * glm::vec4(p_W, 1.0F);
  const glm::vec2 size(kWindow.width, kWindow.height);
  return 0.5F * size * (glm::vec2(1.0F, 1.0F) + glm::vec2(clip.x, -clip.y) / clip.w);
}

// px, to the right of where the left eye sees it: positive behind the screen.
glm::vec2 disparity(const Stereo& stereo, const Camera& camera, const glm::vec3& p_W) {
  return pixel_of(seen_by(Eye::right, stereo, camera), p_W) -
         pixel_of(seen_by(Eye::left, stereo, camera), p_W);
}

TEST(StereoFrusta, DisparityIsThatOfTheory) {
  Camera camera = kAhead;
  camera.eyes = {0.02F, 0.4F};
  const float focal = 0.5F * static_cast<float>(kWindow.height) / std::tan(0.35F);  // px
  for (const float z : {0.1F, 0.25F, 0.4F, 0.7F, 5.0F, 900.0F})
    for (const glm::vec2& beside : {glm::vec2(0.0F), glm::vec2(0.05F, 0.02F), glm::vec2(-0.1F, 0.3F)}) {
      const glm::vec3 p_W = camera.eye + glm::vec3(beside, -z);
      const glm::vec2 found = disparity(kNoScreen, camera, p_W);
      EXPECT_NEAR(found.x, focal * 0.02F * (1.0F / 0.4F - 1.0F / z), 0.02F) << z;
      EXPECT_NEAR(found.y, 0.0F, 0.005F) << "one eye would have to look higher";
    }
}

TEST(StereoFrusta, WhatIsInTheWindowsPlaneIsAtTheScreen) {
  for (const auto& convergence : {std::optional<float>(), std::optional<float>(0.3F)}) {
    Camera camera = kAhead;
    camera.eyes.convergence = convergence;
    const glm::vec3 middle = camera.eye - glm::vec3(0, 0, convergence.value_or(0.5F));
    for (const glm::vec3& beside : {glm::vec3(0), glm::vec3(0.1F, 0.05F, 0), glm::vec3(-0.3F, 0.2F, 0)})
      EXPECT_NEAR(glm::length(disparity(kNoScreen, camera, middle + beside)), 0.0F, 0.01F);
  }
}

TEST(StereoFrusta, EyesTurnWithTheCamera) {
  const Camera above{{0.0F, 0.5F, 0.0F}, {0.0F, 0.0F, 0.0F}, 0.7F};  // straight down: up is -z
  const Camera right = seen_by(Eye::right, kNoScreen, above);
  EXPECT_NEAR(right.eye.x, 0.5F * eye_distance_of(above), 1e-6F);
  EXPECT_NEAR(right.eye.y, 0.5F, 1e-6F);
  const Camera from_the_right{{0.5F, 0.0F, 0.0F}, {0.0F, 0.0F, 0.0F}, 0.7F};
  EXPECT_NEAR(seen_by(Eye::right, kNoScreen, from_the_right).eye.z, -0.5F * eye_distance_of(above), 1e-6F);
}

TEST(StereoFrusta, WithoutADistanceBothEyesAreTheOne) {
  Camera camera = kAhead;
  camera.eyes.distance = 0.0F;
  for (const Eye eye : {Eye::left, Eye::middle, Eye::right})
    EXPECT_EQ(clip_from_world(seen_by(eye, kNoScreen, camera), kWindow), clip_from_world(camera, kWindow));
}

// The farthest point of all, and one halfway to the window, are a fiftieth of the width apart, at any field
// of view and any distance: 26 px of 1280.
TEST(StereoFrusta, UnlessToldOtherwiseDisparityStaysWithinAFiftieth) {
  for (const float fov : {0.2F, 0.7F, 1.4F})
    for (const float distance : {0.05F, 0.5F, 8.0F}) {
      const Camera camera{{0, 0, distance}, {0, 0, 0}, fov};
      EXPECT_NEAR(disparity(kNoScreen, camera, {0, 0, -1e6F}).x, 0.02F * 1280.0F, 0.1F);
      EXPECT_NEAR(disparity(kNoScreen, camera, {0, 0, 0.5F * distance}).x, -0.02F * 1280.0F, 0.1F);
    }
}

// A window of 0.3 m in a scene that is twice as large as life, 0.6 m before a head: by hand, where a straight
// line from either eye to a point crosses the window.
TEST(StereoFrusta, AScreenIsAWindowBeforeTheHead) {
  const float half_height = 0.5F * std::tan(0.35F);  // m, of the window in the scene
  const float scale = 2.0F;
  Stereo stereo;
  stereo.screen = Screen{2.0F * half_height / scale, {0.05F, -0.03F, 0.6F}, 0.063F};
  for (const glm::vec3& p_W : {glm::vec3(0.02F, 0.12F, 0.1F), glm::vec3(-0.3F, 0.0F, -2.0F)})
    for (const Eye eye : {Eye::left, Eye::middle, Eye::right}) {
      const float side = eye == Eye::left ? -1.0F : eye == Eye::right ? 1.0F : 0.0F;
      const glm::vec3 at = kAhead.target + scale * glm::vec3(0.05F + side * 0.0315F, -0.03F, 0.6F);
      const float part = at.z / (at.z - p_W.z);
      const glm::vec3 crossing = at + part * (p_W - at) - kAhead.target;
      const glm::vec2 expected =
          0.5F * glm::vec2(1280.0F, 720.0F) + 360.0F / half_height * glm::vec2(crossing.x, -crossing.y);
      EXPECT_NEAR(glm::distance(pixel_of(seen_by(eye, stereo, kAhead), p_W), expected), 0.0F, 0.02F);
    }
  const glm::vec3 corner = kAhead.target + glm::vec3(16.0F / 9.0F * half_height, half_height, 0.0F);
  for (const Eye eye : {Eye::left, Eye::middle, Eye::right})
    EXPECT_NEAR(glm::distance(pixel_of(seen_by(eye, stereo, kAhead), corner), {1280.0F, 0.0F}), 0.0F, 0.02F)
        << "the window stays where it is, whoever looks through it";
}

TEST(StereoFrusta, AHeadWhereTheCameraIsSeesWhatItSees) {
  Stereo stereo;
  stereo.screen = Screen{2.0F * 0.5F * std::tan(0.35F), {0, 0, 0.5F}, 0.063F};
  const Camera middle = seen_by(Eye::middle, stereo, kAhead);
  for (const glm::vec3& p_W : {glm::vec3(0.02F, 0.12F, 0.1F), glm::vec3(-0.3F, 0.0F, -2.0F)})
    EXPECT_NEAR(glm::distance(pixel_of(middle, p_W), pixel_of(kAhead, p_W)), 0.0F, 0.01F);
}

}  // namespace
}  // namespace fulcrum::render
