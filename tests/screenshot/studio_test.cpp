// The studio that references take their light from is the one that the picture mirrors: one is written for
// the processor, the other for shaders.

#include "engine/render/studio.h"

#include <gtest/gtest.h>

#include <algorithm>
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

  // The middle of a picture of a mirror at the origin, 0..1, seen from there along -z.
  glm::vec3 mirrored(const Ambient& ambient, const glm::mat4& turn) {
    VisualDesc desc;
    desc.meshes = {test::make_box({0.2F, 0.2F, 0.01F})};
    desc.materials = {{"mirror", glm::vec3(1.0F), 1.0F, 0.045F}};
    desc.instances = {{0, 0, "mirror", turn}};
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
        const glm::vec3 seen = mirrored(ambient, turn);
        for (int i = 0; i < 3; ++i) EXPECT_NEAR(seen[i], wanted[i], 0.03F) << pitch << " " << yaw << " " << i;
        darkest = std::min(darkest, seen.g);
        brightest = std::max(brightest, seen.g);
      }
    }
  }
  EXPECT_GT(brightest, darkest + 0.3F) << "a box and a wall are among them";
}

}  // namespace
}  // namespace fulcrum::render
