#pragma once
// A floor of which one half is lit, for tests of light that spreads below it.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/glm.hpp>

#include "test_scene.h"

namespace fulcrum::test {

class HalfLitFloor : public testing::Test {
public:
  static int at(const render::Picture& picture, std::uint32_t x, std::uint32_t y, std::size_t channel = 1) {
    return picture.rgba[4 * (std::size_t{y} * picture.width + x) + channel];
  }

  static constexpr float kReflected = 0.5F;
  static constexpr render::Extent kSize{320, 240};

protected:
  void TearDown() override {
    for (const std::string& message : gpu_.instance.messages()) ADD_FAILURE() << message;
  }

  // A square of the floor with this normal in all its corners.
  static void add_square(render::Mesh& mesh, float left, float right, float y, const glm::vec3& normal) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    for (const glm::vec3& corner :
         {glm::vec3{left, y, 1}, {right, y, 1}, {right, y, -1}, glm::vec3{left, y, -1}}) {
      mesh.positions.push_back(corner);
      mesh.normals.push_back(normal);
    }
    for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) mesh.indices.push_back(first + corner);
  }

  // Lit where x < 0 by a lamp above; the rest is turned away from it, for its normals alone. Matt, without
  // any gloss. The picture shows `across` of its x (m).
  static render::VisualDesc half_lit(const glm::vec3& d, float across, float away = 0.5F) {
    render::VisualDesc desc;
    render::Mesh mesh;
    add_square(mesh, -1.0F, 0.0F, 0.0F, {0, 1, 0});
    add_square(mesh, 0.0F, 1.0F, 0.0F, {1, 0, 0});
    desc.meshes = {mesh};
    render::SurfaceDetail detail;
    detail.f0 = glm::vec3(0.0F);
    detail.f90 = 0.0F;
    detail.scatter_distance = d;
    desc.materials = {{"flesh", glm::vec3(kReflected), 0.0F, 1.0F, detail}};
    desc.instances = {{0, 0, "floor", glm::mat4(1.0F), true, false}};
    desc.ambient.intensity = 0.0F;
    desc.key_light->direction = {0.0F, -1.0F, 0.0F};
    desc.key_light->colour = glm::vec3(1.0F);
    desc.key_light->intensity = 1.0F;
    desc.key_light->casts_shadow = false;
    const float tangent = 0.5F * across / away * static_cast<float>(kSize.height) / kSize.width;
    desc.camera = {{0.0F, away, 0.0F}, glm::vec3(0.0F), 2.0F * std::atan(tangent)};
    return desc;
  }

  static render::Quality quality(int taps, int samples = 1) {
    return {samples, 0, 1.0F, 0.0F, false, false, taps};
  }

  render::Picture drawn(const render::VisualDesc& desc, const render::Quality& how) {
    const auto renderer = render::Renderer::create(*gpu_.device, desc, {kSize, how, {}});
    if (!renderer) throw std::runtime_error(renderer.error().sentence);
    render::FrameState state;
    state.camera = desc.camera;
    std::vector<glm::mat4> poses;
    for (const render::Instance& instance : desc.instances)
      if (instance.movable) poses.push_back(instance.X_WM);
    state.X_WM = poses;
    EXPECT_FALSE((*renderer)->frame(state));
    return *(*renderer)->read_back();
  }

  Gpu gpu_ = make_gpu("llvmpipe");
};

}  // namespace fulcrum::test
