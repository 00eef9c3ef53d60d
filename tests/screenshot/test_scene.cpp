#include "test_scene.h"

#include <array>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <numbers>
#include <stdexcept>

#include "engine/render/tone.h"

namespace fulcrum::test {
using render::Mesh;
using render::VisualDesc;

Mesh make_box(const glm::vec3& half_size) {
  Mesh mesh;
  mesh.name = "box";
  for (int axis = 0; axis < 3; ++axis) {
    for (const float sign : {-1.0F, 1.0F}) {
      glm::vec3 normal(0.0F);
      normal[axis] = sign;
      glm::vec3 u(0.0F);
      u[(axis + 1) % 3] = 1.0F;
      const glm::vec3 v = glm::cross(normal, u);
      const auto first = static_cast<std::uint32_t>(mesh.positions.size());
      for (const auto& [s, t] : std::array<std::array<float, 2>, 4>{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}}) {
        mesh.positions.push_back((normal + s * u + t * v) * half_size);
        mesh.normals.push_back(normal);
      }
      for (const std::uint32_t corner : {0U, 1U, 2U, 0U, 2U, 3U}) mesh.indices.push_back(first + corner);
    }
  }
  return mesh;
}

Mesh make_ball(float radius) {
  constexpr std::uint32_t rings = 24;
  constexpr std::uint32_t sectors = 48;
  Mesh mesh;
  mesh.name = "ball";
  for (std::uint32_t i = 0; i <= rings; ++i) {
    for (std::uint32_t j = 0; j <= sectors; ++j) {
      const float polar = std::numbers::pi_v<float> * static_cast<float>(i) / rings;
      const float around = 2.0F * std::numbers::pi_v<float> * static_cast<float>(j) / sectors;
      const glm::vec3 normal{std::sin(polar) * std::sin(around), std::cos(polar),
                             std::sin(polar) * std::cos(around)};
      mesh.positions.push_back(radius * normal);
      mesh.normals.push_back(normal);
    }
  }
  for (std::uint32_t i = 0; i < rings; ++i) {
    for (std::uint32_t j = 0; j < sectors; ++j) {
      const std::uint32_t a = i * (sectors + 1) + j;
      const std::uint32_t below = a + sectors + 1;
      for (const std::uint32_t corner : {a, below, below + 1, a, below + 1, a + 1})
        mesh.indices.push_back(corner);
    }
  }
  return mesh;
}

VisualDesc make_scene() {
  VisualDesc desc;
  desc.meshes = {make_box({1.0F, 0.01F, 1.0F}), make_box({0.06F, 0.06F, 0.06F}), make_ball(0.05F)};
  desc.materials = {{"floor", glm::vec3(0.3F), 0.0F, 0.8F},
                    {"red paint", {0.5F, 0.03F, 0.02F}, 0.0F, 0.35F},
                    {"chrome", glm::vec3(0.78F), 1.0F, 0.08F}};
  const auto at = [](float x, float y, float z) { return glm::translate(glm::mat4(1.0F), {x, y, z}); };
  desc.instances = {{0, 0, "floor", at(0, -0.01F, 0), false, false},
                    {1, 1, "box", at(-0.1F, 0.06F, 0), false, true},
                    {2, 2, "ball", at(0.1F, 0.12F, 0), true, true}};
  desc.key_light->direction = {0.0F, -1.0F, 0.0F};
  desc.camera = {{0.0F, 0.35F, 0.6F}, {0.0F, 0.05F, 0.0F}, 0.7F};
  desc.markers = {{"above the box", {-0.1F, 0.2F, 0.0F}, 0.02F}};
  desc.ghosts = {render::Ghost{}};
  return desc;
}

Gpu make_gpu(const std::string& name) {
  vulkan::Result<vulkan::Instance> instance = vulkan::Instance::create({true, {}});
  if (!instance) throw std::runtime_error(instance.error().sentence);
  vulkan::Result<std::unique_ptr<vulkan::Device>> device = vulkan::Device::create(*instance, name);
  if (!device) throw std::runtime_error(device.error().sentence);
  return {std::move(*instance), std::move(*device)};
}

glm::vec3 mean(const render::Picture& picture, float left, float top, float right, float bottom) {
  const auto column = [&](float part) {
    return static_cast<std::size_t>(part * static_cast<float>(picture.width));
  };
  const auto row = [&](float part) {
    return static_cast<std::size_t>(part * static_cast<float>(picture.height));
  };
  glm::vec3 sum(0.0F);
  float count = 0.0F;
  for (std::size_t y = row(top); y < row(bottom); ++y) {
    for (std::size_t x = column(left); x < column(right); ++x) {
      const std::uint8_t* pixel = &picture.rgba[(y * picture.width + x) * 4];
      sum += glm::vec3(pixel[0], pixel[1], pixel[2]);
      count += 1.0F;
    }
  }
  return sum / count;
}

double radiance_of(float value) {
  float low = 0.0F, high = 4.0F;
  for (int i = 0; i < 40; ++i) {
    const float middle = 0.5F * (low + high);
    (255.0F * render::tone_mapped(glm::vec3(middle)).g < value ? low : high) = middle;
  }
  return static_cast<double>(low);
}

}  // namespace fulcrum::test
