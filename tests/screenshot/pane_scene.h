#pragma once
// A pane before the camera, of which is known on paper what is to be seen, and what is read from its picture.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "test_scene.h"

namespace fulcrum::test {

// 10 cm wide and high, in the plane z = 0, seen from +z; u to the right, v downwards.
inline render::Mesh pane() {
  render::Mesh mesh;
  mesh.name = "pane";
  mesh.positions = {{-0.05F, 0.05F, 0}, {0.05F, 0.05F, 0}, {0.05F, -0.05F, 0}, {-0.05F, -0.05F, 0}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.uv = {{0, 0, 0, 0}, {1, 0, 0, 0}, {1, 1, 0, 0}, {0, 1, 0, 0}};
  mesh.indices = {0, 2, 1, 0, 3, 2};
  return mesh;
}

inline render::Texture flat(const std::array<std::uint8_t, 4>& colour, bool srgb = true) {
  return {"flat", 1, 1, {colour.begin(), colour.end()}, srgb};
}

// Red, green over blue, white.
inline render::Texture four_colours() {
  return {"four colours", 2, 2, {255, 0, 0, 255, 0, 255, 0, 255, 0, 0, 255, 255, 255, 255, 255, 255}, true};
}

inline render::VisualDesc pane_scene() {
  render::VisualDesc desc;
  desc.meshes = {pane()};
  desc.materials = {{"pane", glm::vec3(1.0F), 0.0F, 0.6F, render::SurfaceDetail{}}};
  desc.instances = {{0, 0, "pane"}};
  desc.key_light.reset();
  desc.camera = {{0, 0, 0.3F}, {0, 0, 0}, 0.5F};  // the pane is two thirds of the picture's height
  return desc;
}

class PaneTest : public testing::Test {
protected:
  void TearDown() override {
    for (const std::string& message : gpu_.instance.messages()) ADD_FAILURE() << message;
  }

  render::Picture draw(const render::VisualDesc& desc, const render::Quality& quality = {1, 512, 1.0F},
                       render::Extent extent = {180, 180}) {
    const auto renderer = render::Renderer::create(*gpu_.device, desc, {extent, quality, {}});
    if (!renderer) throw std::runtime_error(renderer.error().sentence);
    std::vector<glm::mat4> poses;
    for (const render::Instance& instance : desc.instances)
      if (instance.movable) poses.push_back(instance.X_WM);
    render::FrameState state;
    state.X_WM = poses;
    state.camera = desc.camera;
    const std::optional<Error> error = (*renderer)->frame(state);
    EXPECT_FALSE(error) << error->sentence;
    return *(*renderer)->read_back();
  }

  // Of the pane's corners, from the top left clockwise: 'r', 'g', 'b', 'w'.
  static std::string corners(const render::Picture& picture) {
    std::string found;
    for (const auto& [x, y] : {std::pair(0.3F, 0.3F), {0.6F, 0.3F}, {0.6F, 0.6F}, {0.3F, 0.6F}}) {
      const glm::vec3 c = mean(picture, x, y, x + 0.1F, y + 0.1F);
      const float least = std::min({c.r, c.g, c.b}), most = std::max({c.r, c.g, c.b});
      found += most - least < 0.2F * most ? 'w' : most == c.r ? 'r' : most == c.g ? 'g' : 'b';
    }
    return found;
  }

  static float brightness(const render::Picture& picture) {
    const glm::vec3 c = mean(picture, 0.4F, 0.4F, 0.6F, 0.6F);
    return c.r + c.g + c.b;
  }

  Gpu gpu_ = make_gpu("llvmpipe");
};

}  // namespace fulcrum::test
