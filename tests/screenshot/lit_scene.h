#pragma once
// A scenario whose models bring lights, drawn from its files, and what is to be read from its pixels.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <memory>
#include <numbers>
#include <stdexcept>
#include <string>
#include <vector>

#include "engine/render/tone.h"
#include "engine/scenario/assemble.h"
#include "lit_glb.h"
#include "test_scene.h"
#include "tests/scenario/example.h"

namespace fulcrum::test {

inline constexpr double kAlbedo = 0.8;

// Matt, without the layer that reflects.
inline constexpr const char* kMatt =
    R"({"name":"matt","pbrMetallicRoughness":{"baseColorFactor":[0.8,0.8,0.8,1],"metallicFactor":0},)"
    R"("extensions":{"KHR_materials_specular":{"specularFactor":0}}})";

inline constexpr const char* kModels = R"(models:
  block: {file: floor.glb, role: scene}
  peg: {file: peg.glb, role: tool}
  lamps: {file: lamps.glb, role: decor)";

// I cos / d^2 on a floor, of a point at `from`.
inline double from_point(double intensity, const glm::dvec3& from, const glm::dvec3& p_W) {
  const double d = glm::length(from - p_W);
  return intensity * (from.y - p_W.y) / (d * d * d);
}

class LitScene : public testing::Test {
protected:
  LitScene() {
    LitGlb floor;
    floor.parts = {{make_box({1.5F, 0.01F, 1.5F}), {0, -0.01F, 0}, kMatt}};
    folder_.write("scenarios/peg/floor.glb", floor.bytes());
    folder_.write("scenarios/peg/peg.glb", peg({}, {}));
  }

  void TearDown() override {
    for (const std::string& message : gpu_.instance.messages()) ADD_FAILURE() << message;
  }

  // 10 x 40 x 10 mm with its foot at the origin, so that it is moved about (0, 20 mm, 0).
  static std::string peg(const std::vector<std::string>& lights, const std::vector<std::string>& nodes) {
    return LitGlb{{{make_box({0.005F, 0.02F, 0.005F}), {0, 0.02F, 0}, kMatt}}, lights, nodes}.bytes();
  }

  // A floor whose top is y = 0, the tool beside it, and a model with that light; lit by nothing else.
  // entry: more keys of that model.
  render::VisualDesc lit_by(const std::string& light, const std::string& node,
                            const std::string& entry = "") {
    // What a model is made of lies below the floor, and is seen from nowhere.
    const LitGlb lamps{{{make_box(glm::vec3(0.01F)), {0, -0.2F, 0}, kMatt}}, {light}, {node}};
    folder_.write("scenarios/peg/lamps.glb", lamps.bytes());
    return assembled(entry);
  }

  render::VisualDesc assembled(const std::string& entry, const std::vector<std::string>& overrides = {}) {
    std::string text = scenario::test::kScenario;
    const std::size_t first = text.find("models:"), last = text.find("tool:\n");
    text.replace(first, last - first, kModels + entry + "}\n");
    const auto scenario = scenario::load_scenario_text(text, folder_.peg(), overrides);
    if (!scenario) throw std::runtime_error(to_text(scenario.faults()));
    const auto models = scenario::load_models(*scenario);
    if (!models) throw std::runtime_error(to_text(models.faults()));
    auto visual = scenario::assemble_visual(*scenario, *models, {});
    if (!visual) throw std::runtime_error(to_text(visual.faults()));
    visual->desc.key_light.reset();
    visual->desc.ambient.intensity = 0.0F;
    return std::move(visual->desc);
  }

  std::unique_ptr<render::Renderer> renderer(const render::VisualDesc& desc, render::Extent extent,
                                             const render::Quality& quality) {
    auto made = render::Renderer::create(*gpu_.device, desc, {extent, quality, {}});
    if (!made) throw std::runtime_error(made.error().sentence);
    return std::move(*made);
  }

  // What `expect_lit` looks at.
  std::unique_ptr<render::Renderer> close_up(const render::VisualDesc& desc) {
    return renderer(desc, {48, 48}, {1, 0, 1.0F});
  }

  static render::Picture draw(render::Renderer& renderer, const render::Camera& camera, const glm::mat4& X_WT,
                              const render::LatePoses& late = {}) {
    render::FrameState state;
    state.X_WM = {&X_WT, 1};
    state.camera = camera;
    const auto error = renderer.frame(state, {}, late);
    if (error) throw std::runtime_error(error->sentence);
    return *renderer.read_back();
  }

  // Radiance of a place on the floor, from the pixels that show so much of it (m).
  static float seen_at(render::Renderer& close_up, const glm::vec3& p_W, const glm::mat4& X_WT, float width) {
    const render::Picture picture = draw(close_up, {p_W + glm::vec3(0.1F, 1.0F, 0.2F), p_W, width}, X_WT);
    const float shown = mean(picture, 0.25F, 0.25F, 0.75F, 0.75F).g / 255.0F;
    float low = 0.0F, high = 16.0F;
    for (int i = 0; i < 40; ++i) {
      const float middle = 0.5F * (low + high);
      (render::tone_mapped(glm::vec3(middle)).g < shown ? low : high) = middle;
    }
    return low;
  }

  // E: illuminance (lx).
  static void expect_lit(render::Renderer& close_up, const glm::vec3& p_W, double E,
                         const glm::mat4& X_WT = away(), float width = 0.02F) {
    const double wanted = kAlbedo * E / (683 * std::numbers::pi);
    EXPECT_NEAR(seen_at(close_up, p_W, X_WT, width), wanted, 0.015 * wanted + 0.0005)
        << "at " << p_W.x << " " << p_W.y << " " << p_W.z;
  }

  // Where the tool throws light on nothing and hides nothing.
  static glm::mat4 away() { return glm::translate(glm::mat4(1.0F), {0, 0.1F, -1.4F}); }

  scenario::test::Folder folder_;
  Gpu gpu_ = make_gpu("llvmpipe");
};

}  // namespace fulcrum::test
