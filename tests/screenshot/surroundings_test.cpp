// A scene that has its light from a picture: what is drawn of it, and that others build nothing for one.

#include "engine/render/surroundings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <numbers>

#include "engine/render/frame_data.h"
#include "engine/render/tone.h"
#include "engine/render/turned.h"
#include "image_compare.h"
#include "test_scene.h"

namespace fulcrum::render {
namespace {

constexpr float kFullTurn = 2.0F * std::numbers::pi_v<float>;

// A meadow at evening: a sky that is bright at the horizon, hills, posts towards +x (red), +z (green) and -x
// (blue), and a low sun of half a degree.
glm::vec3 meadow(const glm::vec3& d) {
  const glm::vec3 sun = glm::normalize(glm::vec3(0.5F, 0.45F, 0.9F));
  if (glm::dot(d, sun) > std::cos(0.5F * kFullTurn / 360.0F)) return {9000.0F, 7000.0F, 4500.0F};
  const float azimuth = std::atan2(d.z, d.x);
  const float hills = 0.05F + 0.04F * std::sin(3.0F * azimuth) + 0.02F * std::sin(11.0F * azimuth);
  const auto post = [&](const glm::vec3& towards) {
    return glm::dot(glm::normalize(glm::vec3(d.x, 0.0F, d.z)), towards) > 0.99F && std::abs(d.y) < 0.35F;
  };
  if (post({1, 0, 0})) return {0.9F, 0.05F, 0.05F};
  if (post({0, 0, 1})) return {0.05F, 0.7F, 0.08F};
  if (post({-1, 0, 0})) return {0.06F, 0.1F, 0.9F};
  if (d.y < 0.0F) return glm::mix(glm::vec3(0.10F, 0.16F, 0.05F), glm::vec3(0.03F, 0.05F, 0.02F), -d.y);
  if (d.y < hills) return {0.05F, 0.09F, 0.06F};
  return glm::mix(glm::vec3(1.1F, 0.85F, 0.6F), glm::vec3(0.16F, 0.28F, 0.6F), std::sqrt(d.y));
}

template <typename Value>
Panorama panorama_of(const Value& value) {
  Panorama picture{1024, 512, {}, true};
  for (std::uint32_t row = 0; row < picture.height; ++row)
    for (std::uint32_t column = 0; column < picture.width; ++column) {
      const float polar = 0.5F * kFullTurn * (static_cast<float>(row) + 0.5F) / 512.0F;
      const float azimuth = kFullTurn * (static_cast<float>(column) + 0.5F) / 1024.0F;
      picture.pixels.push_back(value(glm::vec3(std::sin(polar) * std::sin(azimuth), std::cos(polar),
                                               -std::sin(polar) * std::cos(azimuth))));
    }
  return picture;
}

// A mirror, rougher and rougher metal, and matt balls, on a plate.
VisualDesc balls_on_a_meadow() {
  VisualDesc desc;
  Mesh ball;
  add_ball(ball, glm::vec3(0.0F), 0.05F);
  desc.meshes = {ball, test::make_box({0.34F, 0.01F, 0.1F})};
  desc.materials = {{"mirror", glm::vec3(0.95F), 1.0F, 0.05F}, {"brushed", {0.9F, 0.7F, 0.4F}, 1.0F, 0.3F},
                    {"worn", glm::vec3(0.8F), 1.0F, 0.6F},     {"glazed", {0.5F, 0.04F, 0.04F}, 0.0F, 0.1F},
                    {"chalk", glm::vec3(0.8F), 0.0F, 1.0F},    {"plate", glm::vec3(0.25F), 0.0F, 0.7F}};
  for (std::size_t i = 0; i < 5; ++i)
    desc.instances.push_back(
        {0, i, "ball",
         glm::translate(glm::mat4(1.0F), {0.12F * (static_cast<float>(i) - 2.0F), 0.05F, 0.0F})});
  desc.instances.push_back({1, 5, "plate", glm::translate(glm::mat4(1.0F), {0, -0.01F, 0})});
  desc.key_light.reset();
  desc.ambient.picture = panorama_of(meadow);
  desc.camera = {{-0.1F, 0.16F, -0.75F}, {0, 0.05F, 0}, 0.62F};
  return desc;
}

class SurroundingsTest : public testing::Test {
protected:
  void TearDown() override {
    for (const std::string& message : gpu_.instance.messages()) ADD_FAILURE() << message;
  }

  Picture draw(const VisualDesc& desc, const Camera& camera, Extent extent,
               const Quality& quality = {4, 0, 1.0F}) {
    const auto renderer = Renderer::create(*gpu_.device, desc, {extent, quality, {}});
    if (!renderer) throw std::runtime_error(renderer.error().sentence);
    FrameState state;
    state.camera = camera;
    const std::optional<Error> error = (*renderer)->frame(state);
    EXPECT_FALSE(error) << error->sentence;
    return *(*renderer)->read_back();
  }

  test::Gpu gpu_ = test::make_gpu("llvmpipe");
};

TEST_F(SurroundingsTest, BallsOnAMeadow) {
  const VisualDesc desc = balls_on_a_meadow();
  const Picture picture = draw(desc, desc.camera, {640, 360});
  const test::Comparison result =
      test::compare(picture, std::filesystem::path(FULCRUM_GOLDENS) / "surroundings.png",
                    {.max_lsb = 2, .max_pixels = 20, .failure_folder = FULCRUM_FAILURES});
  EXPECT_TRUE(result.passed) << result.sentence;
}

// Where the picture's middle and its corners look, the world's directions say, whichever way a camera is
// turned and leans. A plate far behind the camera makes it a scene.
TEST_F(SurroundingsTest, WhatIsSeenBehindLiesInItsDirection) {
  VisualDesc desc;
  desc.meshes = {test::make_box({0.1F, 0.1F, 0.1F})};
  desc.materials = {{"box"}};
  desc.instances = {{0, 0, "box", glm::translate(glm::mat4(1.0F), {0, 50, 0})}};
  const auto of_direction = [](const glm::vec3& d) { return glm::vec3(0.5F) + 0.45F * d; };
  desc.ambient.picture = panorama_of(of_direction);
  desc.ambient.intensity = 0.8F;
  for (const glm::vec3& target : {glm::vec3(1, 0, 0), glm::vec3(0, 0.1F, 1), glm::vec3(-1, -0.2F, 0),
                                  glm::vec3(0.4F, 0.3F, -0.7F), glm::vec3(0.2F, -0.9F, 0.1F)})
    for (const glm::vec2& lean : {glm::vec2(0.0F), glm::vec2(0.3F, -0.2F)}) {
      Camera camera{glm::vec3(0.0F), target, 0.8F};
      camera.lean = lean;
      const Picture picture = draw(desc, camera, {96, 64}, {1, 0, 1.0F});
      const glm::mat4 world_from_clip = glm::inverse(clip_from_world(camera, {96, 64}));
      for (const glm::vec2& at :
           {glm::vec2(0.5F), glm::vec2(0.1F, 0.15F), glm::vec2(0.9F, 0.2F), glm::vec2(0.2F, 0.85F)}) {
        // One metre away and in the picture there.
        const glm::vec4 place =
            world_from_clip * glm::vec4(2.0F * at.x - 1.0F, 1.0F - 2.0F * at.y, 0.005F, 1.0F);
        const glm::vec3 d = glm::normalize(glm::vec3(place) / place.w);
        const glm::vec3 wanted = tone_mapped(0.8F * of_direction(d));
        const float half = 0.011F;
        const glm::vec3 seen =
            test::mean(picture, at.x - half, at.y - half, at.x + half, at.y + half) / 255.0F;
        for (int i = 0; i < 3; ++i)
          EXPECT_NEAR(seen[i], wanted[i], 0.02F)
              << target.x << " " << target.z << " at " << at.x << " " << at.y;
      }
    }
}

TEST_F(SurroundingsTest, NothingIsBuiltForAPictureThatNoOneNames) {
  VisualDesc desc = balls_on_a_meadow();
  const auto note_of = [](const std::vector<BuildItem>& items, const std::string& name) {
    const auto found = std::ranges::find(items, name, &BuildItem::name);
    return found == items.end() ? std::string() : found->note;
  };
  const auto with = plan(desc, RenderOptions{});
  EXPECT_EQ(note_of(with->built, "surroundings"), "a picture as mirrors of six roughnesses show it");
  EXPECT_EQ(note_of(with->built, "background"), "the surroundings");
  EXPECT_EQ(note_of(with->left_out, "picture of the surroundings"), "");
  desc.ambient.picture->seen = false;
  EXPECT_EQ(note_of(plan(desc, RenderOptions{})->built, "background"), "a gradient");
  desc.ambient.picture.reset();
  const auto without = plan(desc, RenderOptions{});
  EXPECT_EQ(note_of(without->built, "surroundings"), "the studio as mirrors of six roughnesses show it");
  EXPECT_EQ(note_of(without->left_out, "picture of the surroundings"),
            "the scene has its light from the studio");
}

TEST_F(SurroundingsTest, APictureThatIsNoneIsRefused) {
  VisualDesc desc = balls_on_a_meadow();
  desc.ambient.picture->height = 256;
  EXPECT_NE(plan(desc, RenderOptions{}).error().sentence.find("twice as wide as high"), std::string::npos);
  desc.ambient.picture = panorama_of(meadow);
  desc.ambient.picture->pixels[7].g = NAN;
  EXPECT_NE(plan(desc, RenderOptions{}).error().sentence.find("no amount of light"), std::string::npos);
}

}  // namespace
}  // namespace fulcrum::render
