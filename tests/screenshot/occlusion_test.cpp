// A floor before a wall gets as much less light as the wall covers of its sky, and a tool is darkest where it
// touches.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>

#include "engine/render/environment.h"
#include "engine/render/frame_data.h"
#include "engine/render/tone.h"
#include "test_scene.h"

namespace fulcrum::render {
namespace {

class OcclusionTest : public testing::Test {
protected:
  void TearDown() override {
    for (const std::string& message : gpu_.instance.messages()) ADD_FAILURE() << message;
  }

  // Everything may move: the light volume is open, and only the picture's depth can tell what hides what.
  static VisualDesc floor() {
    VisualDesc desc;
    desc.meshes = {test::make_box({1.0F, 0.1F, 1.0F})};
    desc.materials = {{"matt", glm::vec3(0.3F), 0.0F, 1.0F}};
    desc.instances = {{0, 0, "floor", glm::translate(glm::mat4(1.0F), {0, -0.1F, 0}), true}};
    desc.key_light.reset();
    desc.camera = {{0.35F, 0.5F, 0.0F}, {0.04F, 0.0F, 0.0F}, 0.5F};
    return desc;
  }

  Picture drawn(const VisualDesc& desc, bool occlusion) {
    const auto renderer = Renderer::create(*gpu_.device, desc, {kSize, {1, 0, 1.0F, 0.0F, occlusion}, {}});
    if (!renderer) throw std::runtime_error(renderer.error().sentence);
    FrameState state;
    state.camera = desc.camera;
    std::vector<glm::mat4> poses;
    for (const Instance& instance : desc.instances)
      if (instance.movable) poses.push_back(instance.X_WM);
    state.X_WM = poses;
    EXPECT_FALSE((*renderer)->frame(state));
    return *(*renderer)->read_back();
  }

  // Green, 0..1, around the pixels that show a place.
  static float shown_at(const Picture& picture, const Camera& camera, const glm::vec3& place) {
    const glm::vec4 clip = clip_from_world(camera, kSize) * glm::vec4(place, 1.0F);
    const float x = 0.5F + 0.5F * clip.x / clip.w, y = 0.5F - 0.5F * clip.y / clip.w;
    return test::mean(picture, x - 0.01F, y - 0.01F, x + 0.01F, y + 0.01F).g / 255.0F;
  }

  static constexpr Extent kSize{320, 240};
  test::Gpu gpu_ = test::make_gpu("llvmpipe");
};

TEST_F(OcclusionTest, AFloorBeforeAWallGetsWhatTheWallLeavesOfItsSky) {
  VisualDesc desc = floor();
  constexpr float kHeight = 0.06F;
  desc.meshes.push_back(test::make_box({0.05F, 0.5F * kHeight, 1.0F}));
  desc.instances.push_back(
      {1, 0, "wall", glm::translate(glm::mat4(1.0F), {-0.05F, 0.5F * kHeight, 0}), true});
  const Picture picture = drawn(desc, true);
  const Picture without = drawn(desc, false);
  const Irradiance around = make_environment(surroundings_of(desc.ambient)).irradiance;
  const float upwards = irradiance(around, {0, 1, 0}).g;
  for (const float away : {0.012F, 0.02F, 0.03F, 0.045F, 0.09F}) {
    const float open = 0.5F + 0.5F * away / std::sqrt(away * away + kHeight * kHeight);
    const float wanted = tone_mapped(glm::vec3(0.316F * upwards * open)).g;
    const float seen = shown_at(picture, desc.camera, {away, 0, 0});
    EXPECT_NEAR(seen, wanted, 0.025F) << away;
    EXPECT_LT(seen, shown_at(without, desc.camera, {away, 0, 0})) << away;
  }
}

TEST_F(OcclusionTest, AnOpenFloorIsAsBrightAsWithoutIt) {
  const VisualDesc desc = floor();
  const Picture with = drawn(desc, true), without = drawn(desc, false);
  for (const float x : {-0.05F, 0.0F, 0.05F})
    for (const float z : {-0.08F, 0.0F, 0.08F})
      EXPECT_NEAR(shown_at(with, desc.camera, {x, 0, z}), shown_at(without, desc.camera, {x, 0, z}), 0.01F);
}

// Surroundings without light have nothing that could be hidden, and lit things nothing to make up for.
TEST_F(OcclusionTest, InTheDarkAnOpenFloorIsLitByItsLampAlone) {
  VisualDesc desc = floor();
  desc.key_light.emplace();
  desc.ambient.intensity = 0.0F;
  const Picture moving = drawn(desc, true);
  desc.instances[0].movable = false;
  const Picture standing = drawn(desc, true);
  for (const float x : {-0.05F, 0.0F, 0.05F})
    EXPECT_NEAR(shown_at(standing, desc.camera, {x, 0, 0}), shown_at(moving, desc.camera, {x, 0, 0}), 0.01F);
}

TEST_F(OcclusionTest, ABallIsDarkestBelowWhereItTouches) {
  VisualDesc desc = floor();
  desc.meshes.push_back(test::make_ball(0.03F));
  desc.instances.push_back({1, 0, "ball", glm::translate(glm::mat4(1.0F), {0, 0.03F, 0}), true});
  const auto beside_it = [&](float height) {
    desc.instances[1].X_WM = glm::translate(glm::mat4(1.0F), {0, 0.03F + height, 0});
    return shown_at(drawn(desc, true), desc.camera, {0.03F, 0, 0});
  };
  const float touching = beside_it(0.0F), near = beside_it(0.01F), far = beside_it(0.1F);
  EXPECT_LT(touching + 0.02F, near);
  EXPECT_LT(near + 0.02F, far);
}

// A needle a quarter of a metre before the floor is not a wall that deep.
TEST_F(OcclusionTest, AThinThingFarBeforeAFloorDarkensItLittle) {
  VisualDesc desc = floor();
  const Picture without = drawn(desc, true);
  desc.meshes.push_back(test::make_box({0.002F, 0.002F, 0.5F}));
  desc.instances.push_back({1, 0, "needle", glm::translate(glm::mat4(1.0F), {0.2F, 0.25F, 0}), true});
  const Picture with = drawn(desc, true);
  float darkest = 0.0F;
  for (const float x : {-0.05F, -0.03F, 0.12F, 0.15F})
    darkest =
        std::max(darkest, shown_at(without, desc.camera, {x, 0, 0}) - shown_at(with, desc.camera, {x, 0, 0}));
  EXPECT_LT(darkest, 0.04F);
}

}  // namespace
}  // namespace fulcrum::render
