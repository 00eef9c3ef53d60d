#include "surface_balls.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>

#include "test_scene.h"

namespace fulcrum::test {
namespace {

using render::Alpha;
using render::SurfaceDetail;
using render::Texture;
using Rgba = std::array<int, 4>;

// A picture of 64 x 64 pixels, each as `colour` says of its place from -1 to 1.
template <class Colour>
Texture painted(bool srgb, Colour colour) {
  constexpr std::uint32_t n = 64;
  Texture texture{"painted", n, n, {}, srgb};
  for (std::uint32_t y = 0; y < n; ++y)
    for (std::uint32_t x = 0; x < n; ++x)
      for (const int part : colour(2.0F * static_cast<float>(x) / static_cast<float>(n) - 1.0F,
                                   2.0F * static_cast<float>(y) / static_cast<float>(n) - 1.0F))
        texture.rgba.push_back(static_cast<std::uint8_t>(part));
  return texture;
}

Texture checks(bool srgb, const Rgba& one, const Rgba& other) {
  return painted(
      srgb, [&](float x, float y) { return (x < 0.0F) == (y < 0.0F) ? one : other; });
}

// Of a dome.
Rgba bump(float x, float y) {
  const float r = std::sqrt(x * x + y * y), slope = r < 0.8F ? 0.9F * r / 0.8F : 0.0F;
  const float nx = r > 0.0F ? slope * x / r : 0.0F, ny = r > 0.0F ? -slope * y / r : 0.0F;
  const float nz = std::sqrt(std::max(1.0F - nx * nx - ny * ny, 0.0F));
  const auto byte = [](float v) { return static_cast<int>(std::lround(127.5F * (v + 1.0F))); };
  return {byte(nx), byte(ny), byte(nz), 255};
}

render::Material with_texture(const char* name, const glm::vec3& colour, float metallic, float roughness,
                              SurfaceDetail::Kind kind, std::size_t texture) {
  render::Material made{name, colour, metallic, roughness, SurfaceDetail{}};
  made.detail->layers[kind] = render::TextureLayer{.texture = texture};
  return made;
}

std::vector<render::Material> materials() {
  const glm::vec3 white(1.0F), grey(0.5F);
  std::vector<render::Material> all{
      with_texture("base colour", white, 0, 0.5F, SurfaceDetail::base_colour, 0),
      with_texture("metal-rough", {0.9F, 0.7F, 0.4F}, 1, 1, SurfaceDetail::metal_rough, 1),
      with_texture("normal", grey, 0, 0.35F, SurfaceDetail::normal, 2),
      with_texture("occlusion", grey, 0, 0.6F, SurfaceDetail::occlusion, 3),
      with_texture("emissive", glm::vec3(0.05F), 0, 0.5F, SurfaceDetail::emissive, 4),
      with_texture("mask", white, 0, 0.5F, SurfaceDetail::base_colour, 5),
      {"blend", {0.1F, 0.4F, 0.9F}, 0, 0.2F, SurfaceDetail{}},
      {"clear coat", {0.4F, 0.02F, 0.02F}, 0, 0.8F, SurfaceDetail{}},
      {"sheen", {0.05F, 0.05F, 0.2F}, 0, 1, SurfaceDetail{}},
      {"transmission", {0.9F, 1.0F, 0.9F}, 0, 0.05F, SurfaceDetail{}}};
  all[4].detail->emission = glm::vec3(1.5F);
  all[5].detail->alpha = Alpha::mask;
  all[5].detail->double_sided = true;
  all[6].detail->alpha = Alpha::blend;
  all[6].detail->opacity = 0.5F;
  all[7].detail->clearcoat = 1.0F;
  all[8].detail->sheen = {0.6F, 0.6F, 1.0F};
  all[8].detail->sheen_roughness = 0.5F;
  all[9].detail->transmission = 1.0F;
  return all;
}

}  // namespace

std::vector<render::Texture> painted_textures() {
  return {checks(true, {230, 190, 120, 255}, {40, 60, 110, 255}),
          checks(false, {0, 40, 255, 255}, {0, 200, 0, 255}),
          painted(false, bump),
          painted(
              false,
              [](float x, float y) {
                return Rgba{std::max(std::abs(x), std::abs(y)) > 0.85F ? 30 : 255, 0, 0, 255};
              }),
          checks(true, {255, 120, 20, 255}, {0, 0, 0, 255}),
          painted(
              true,
              [](float x, float y) {
                return Rgba{200, 40, 30, x * x + y * y < 0.6F ? 0 : 255};
              })};
}

render::Mesh unwrapped_ball(float radius) {
  render::Mesh ball = make_ball(radius);  // rings of 49 vertices
  for (std::size_t i = 0; i < ball.positions.size(); ++i) {
    const std::size_t ring = i / 49, along = i % 49;
    ball.uv.emplace_back(4.0F * static_cast<float>(along) / 48.0F, 2.0F * static_cast<float>(ring) / 24.0F, 0,
                         0);
  }
  return ball;
}

render::VisualDesc surface_balls() {
  render::VisualDesc desc;
  desc.meshes = {unwrapped_ball(0.04F), make_box({0.6F, 0.01F, 0.3F})};
  desc.textures = painted_textures();
  desc.materials = materials();
  for (std::size_t i = 0; i < desc.materials.size(); ++i) {
    const glm::vec3 at{-0.22F + 0.11F * static_cast<float>(i % 5), 0.04F, i < 5 ? -0.06F : 0.06F};
    desc.instances.push_back({0, i, desc.materials[i].name, glm::translate(glm::mat4(1.0F), at)});
  }
  desc.instances.push_back(
      {1, desc.materials.size(), "floor", glm::translate(glm::mat4(1.0F), {0, -0.01F, 0}), false, false});
  desc.materials.push_back({"floor", glm::vec3(0.35F), 0.0F, 0.8F});
  desc.key_light->direction = {-0.4F, -1.0F, -0.5F};
  desc.camera = {{0.0F, 0.34F, 0.62F}, {0.0F, 0.015F, 0.0F}, 0.42F};
  return desc;
}

}  // namespace fulcrum::test
