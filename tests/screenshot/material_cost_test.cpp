// Materials cost a frame little, however many there are: a driver that compiled their shaders anew in each
// frame, as lavapipe does where these branch on uniforms alone, would take milliseconds for each.

#include <gtest/gtest.h>
#include <time.h>

#include <algorithm>
#include <cstdlib>
#include <glm/ext/matrix_transform.hpp>
#include <limits>

#include "test_scene.h"

namespace fulcrum::render {
namespace {

constexpr std::size_t kBoxes = 40;

// Of all threads: llvmpipe draws in several. s.
double processor_s() {
  timespec now{};
  ::clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// A row of them, which take the materials by turns.
VisualDesc row_of_boxes(std::size_t materials) {
  VisualDesc desc;
  desc.meshes = {test::make_box(glm::vec3(0.004F))};
  desc.materials.assign(materials, {"grey", glm::vec3(0.5F), 0.0F, 0.5F, SurfaceDetail{}});
  for (std::size_t i = 0; i < kBoxes; ++i) {
    const glm::vec3 place{0.01F * static_cast<float>(i) - 0.2F, 0.0F, 0.0F};
    desc.instances.push_back({0, i % materials, "box", glm::translate(glm::mat4(1.0F), place)});
  }
  desc.camera = {{0, 0.1F, 0.5F}, {0, 0, 0}, 0.7F};
  return desc;
}

// Processor time of one frame, the least of several (s).
double frame_cost_s(vulkan::Device& device, const VisualDesc& desc) {
  const auto renderer = Renderer::create(device, desc, {{160, 90}, {1, 512, 1.0F}, {}});
  if (!renderer) throw std::runtime_error(renderer.error().sentence);
  FrameState state;
  state.camera = desc.camera;
  double least = std::numeric_limits<double>::infinity();
  for (int i = 0; i < 8; ++i) {  // the first compiles
    const double before = processor_s();
    EXPECT_FALSE((*renderer)->frame(state));
    least = std::min(least, processor_s() - before);
  }
  return least;
}

// A directional light, and a lamp above the row.
std::vector<PunctualLight> lamps() {
  PunctualLight sun, lamp;
  sun.kind = PunctualLight::Kind::directional;
  lamp.position = {0.0F, 0.1F, 0.1F};
  return {sun, lamp};
}

void expect_costs_little(bool lit) {
  // What compiles must cost what that costs. NOLINTNEXTLINE(concurrency-mt-unsafe): no thread runs yet.
  setenv("MESA_SHADER_CACHE_DISABLE", "true", 1);
  const test::Gpu gpu = test::make_gpu("llvmpipe");
  VisualDesc few = row_of_boxes(1), many = row_of_boxes(kBoxes);
  if (lit) few.lights = many.lights = lamps();
  const double one_s = frame_cost_s(*gpu.device, few), many_s = frame_cost_s(*gpu.device, many);
  testing::Test::RecordProperty("one_ms", std::to_string(1e3 * one_s));
  testing::Test::RecordProperty("many_ms", std::to_string(1e3 * many_s));
  EXPECT_LT(many_s, 5.0 * one_s) << "many " << 1e3 * many_s << " ms, one " << 1e3 * one_s << " ms";
}

TEST(MaterialCost, ManyMaterialsCompileNothingInEachFrame) {
  expect_costs_little(false);
}

TEST(MaterialCost, ManyMaterialsUnderLightsOfModelsCompileNothingInEachFrame) {
  expect_costs_little(true);
}

}  // namespace
}  // namespace fulcrum::render
