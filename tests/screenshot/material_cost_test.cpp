// Materials cost a frame little, however many there are: a driver that compiled their shaders anew in each
// frame, as lavapipe does where these branch on uniforms alone, would take milliseconds for each.

#include <gtest/gtest.h>
#include <time.h>

#include <algorithm>
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
double frame_cost_s(vulkan::Device& device, std::size_t materials) {
  const VisualDesc desc = row_of_boxes(materials);
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

TEST(MaterialCost, ManyMaterialsCompileNothingInEachFrame) {
  const test::Gpu gpu = test::make_gpu("llvmpipe");
  const double one = frame_cost_s(*gpu.device, 1), many = frame_cost_s(*gpu.device, kBoxes);
  RecordProperty("one_ms", std::to_string(1e3 * one));
  RecordProperty("many_ms", std::to_string(1e3 * many));
  EXPECT_LT(many, 5.0 * one) << "many " << 1e3 * many << " ms, one " << 1e3 * one << " ms";
}

}  // namespace
}  // namespace fulcrum::render
