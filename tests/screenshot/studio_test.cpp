// The studio that references take their light from is the one that lights the picture, in which it is a map
// and a few sums.

#include "engine/render/studio.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>

#include "engine/render/tone.h"
#include "test_scene.h"

namespace fulcrum::render {
namespace {

class StudioTest : public testing::Test {
protected:
  void TearDown() override {
    for (const std::string& message : gpu_.instance.messages()) ADD_FAILURE() << message;
  }

  // The middle of a picture of a plate at the origin, 0..1, seen along -z.
  glm::vec3 shown(const Material& material, const Ambient& ambient, const glm::mat4& turn) {
    VisualDesc desc;
    desc.meshes = {test::make_box({0.2F, 0.2F, 0.01F})};
    desc.materials = {material};
    desc.instances = {{0, 0, "plate", turn}};
    desc.key_light.reset();
    desc.ambient = ambient;
    desc.camera = {{0, 0, 0.3F}, {0, 0, 0}, 0.02F};
    const auto renderer = Renderer::create(*gpu_.device, desc, {{32, 32}, {1, 0, 1.0F}, {}});
    if (!renderer) throw std::runtime_error(renderer.error().sentence);
    FrameState state;
    state.camera = desc.camera;
    EXPECT_FALSE((*renderer)->frame(state));
    return test::mean(*(*renderer)->read_back(), 0.4F, 0.4F, 0.6F, 0.6F) / 255.0F;
  }

  test::Gpu gpu_ = test::make_gpu("llvmpipe");
};

// Directions all round, boxes among them; a mirror that is turned by half an angle shows what lies at the
// whole one.
TEST_F(StudioTest, AMirrorShowsWhatReferencesAreLitBy) {
  float darkest = 1.0F, brightest = 0.0F;
  for (const bool left_handed : {false, true}) {
    Ambient ambient;
    ambient.mirrored = left_handed;
    for (const float pitch : {-0.6F, -0.3F, 0.3F, 0.6F, 0.7F}) {
      for (const float yaw : {-0.6F, -0.4F, 0.0F, 0.3F, 0.5F}) {
        const glm::mat4 turn = glm::rotate(glm::rotate(glm::mat4(1.0F), yaw, {0, 1, 0}), -pitch, {1, 0, 0});
        const glm::vec3 normal = glm::mat3(turn) * glm::vec3(0, 0, 1);
        const glm::vec3 wanted =
            tone_mapped(studio_radiance(ambient, glm::reflect(glm::vec3(0, 0, -1), normal)));
        const glm::vec3 seen = shown({"mirror", glm::vec3(1.0F), 1.0F, 0.045F}, ambient, turn);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(seen[i], wanted[i], 0.03F) << pitch << " " << yaw << " " << i;
        darkest = std::min(darkest, seen.g);
        brightest = std::max(brightest, seen.g);
      }
    }
  }
  EXPECT_GT(brightest, darkest + 0.3F) << "a box and a wall are among them";
}

// The mean of the radiance over directions spread evenly, weighed by the cosine; a matt surface sends back
// its colour's share of it, and 1.6 % as a dull mirror.
TEST_F(StudioTest, AMattPlateReceivesWhatReferencesAreLitBy) {
  const Ambient ambient;
  for (const float pitch : {-1.2F, -0.4F, 0.0F, 0.5F, 1.2F}) {
    const glm::mat4 turn = glm::rotate(glm::mat4(1.0F), -pitch, {1, 0, 0});
    const glm::vec3 normal = glm::mat3(turn) * glm::vec3(0, 0, 1);
    glm::vec3 sum(0.0F);
    constexpr int kDirections = 20000;
    for (int i = 0; i < kDirections; ++i) {
      const float y = 1.0F - (static_cast<float>(i) + 0.5F) * 2.0F / kDirections;
      const float across = std::sqrt(1.0F - y * y), azimuth = 2.399963F * static_cast<float>(i);
      const glm::vec3 from(across * std::cos(azimuth), y, across * std::sin(azimuth));
      sum += studio_radiance(ambient, from) * std::max(0.0F, glm::dot(from, normal));
    }
    const glm::vec3 irradiance = sum * (4.0F / kDirections);  // over pi
    const glm::vec3 seen = shown({"matt", glm::vec3(0.3F), 0.0F, 1.0F}, ambient, turn);
    const glm::vec3 wanted = tone_mapped(irradiance * 0.316F);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(seen[i], wanted[i], 0.02F) << pitch << " " << i;
  }
}

}  // namespace
}  // namespace fulcrum::render
