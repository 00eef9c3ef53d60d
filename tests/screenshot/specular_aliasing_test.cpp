// Metal that is bent within a pixel, by its shape or by a texture of normals, mirrors there what it does in
// the mean of the pixels of a picture many times as large.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <numbers>
#include <random>

#include "engine/render/tone.h"
#include "test_scene.h"

namespace fulcrum::render {
namespace {

constexpr std::uint32_t kFar = 24, kNear = 30 * kFar;  // pixels

// Radiance 1 within 30 degrees of +z, towards the camera, and none elsewhere.
Panorama cap() {
  constexpr std::uint32_t kWidth = 256, kHeight = 128;
  Panorama made{kWidth, kHeight, {}, false};
  for (std::uint32_t row = 0; row < kHeight; ++row)
    for (std::uint32_t column = 0; column < kWidth; ++column) {
      const double azimuth = 2 * std::numbers::pi * (column + 0.5) / kWidth;
      const double elevation = std::numbers::pi * (0.5 - (row + 0.5) / kHeight);
      const bool is_bright = -std::cos(azimuth) * std::cos(elevation) > std::cos(std::numbers::pi / 6);
      made.pixels.emplace_back(is_bright ? 1.0F : 0.0F);
    }
  return made;
}

// A square of metal, 10 cm wide, in the plane z = 0, of 96 strips along y, and seen from 3 m away.
VisualDesc square() {
  constexpr int kStrips = 96;
  VisualDesc desc;
  desc.key_light.reset();
  desc.ambient.picture = cap();
  Mesh mesh;
  for (int i = 0; i <= kStrips; ++i)
    for (const float v : {0.0F, 1.0F}) {
      const float u = static_cast<float>(i) / kStrips;
      mesh.positions.emplace_back(0.1F * (u - 0.5F), 0.1F * (0.5F - v), 0.0F);
      mesh.normals.emplace_back(0, 0, 1);
      mesh.uv.emplace_back(2.0F * u, 2.0F * v, 0, 0);
    }
  for (std::uint32_t i = 0; i < 2 * kStrips; i += 2)
    mesh.indices.insert(mesh.indices.end(), {i, i + 1, i + 2, i + 2, i + 1, i + 3});
  desc.meshes = {mesh};
  desc.materials = {{"metal", glm::vec3(1.0F), 1.0F, 0.15F}};
  desc.instances = {{0, 0, "square"}};
  desc.camera = {{0, 0, 3.0F}, {0, 0, 0}, 0.03F};
  return desc;
}

// Radiance of each pixel, row by row.
std::vector<double> drawn(vulkan::Device& device, const VisualDesc& desc, std::uint32_t side) {
  const auto renderer =
      Renderer::create(device, desc, {{side, side}, {1, 0, 1.0F, 0.0F, false, false, 0, false}, {}});
  if (!renderer) throw std::runtime_error(renderer.error().sentence);
  FrameState state;
  state.camera = desc.camera;
  if (const auto error = (*renderer)->frame(state)) throw std::runtime_error(error->sentence);
  const Picture picture = *(*renderer)->read_back();
  std::array<double, 256> radiance{};
  for (int i = 0, byte = 0; byte < 256 && i < 100000; ++i) {
    const float of = 1e-4F * static_cast<float>(i);
    while (byte < 256 && 255.0F * tone_mapped(glm::vec3(of)).g >= static_cast<float>(byte))
      radiance[static_cast<std::size_t>(byte++)] = static_cast<double>(of);
  }
  std::vector<double> all;
  for (std::uint32_t i = 0; i < side * side; ++i) all.push_back(radiance[picture.rgba[4 * i + 1]]);
  return all;
}

struct Seen {
  double near = 0, far = 0;  // mean radiance
  double error = 0;          // root mean square, of the pixels seen from afar
};

Seen seen(vulkan::Device& device, const VisualDesc& desc) {
  constexpr std::uint32_t kEach = kNear / kFar;
  const std::vector<double> fine = drawn(device, desc, kNear), coarse = drawn(device, desc, kFar);
  std::vector<double> means(coarse.size(), 0.0);
  for (std::uint32_t y = 0; y < kNear; ++y)
    for (std::uint32_t x = 0; x < kNear; ++x)
      means[std::size_t{y / kEach} * kFar + x / kEach] += fine[std::size_t{y} * kNear + x] / (kEach * kEach);
  Seen found;
  for (std::size_t i = 0; i < means.size(); ++i) {
    const auto count = static_cast<double>(means.size());
    found.near += means[i] / count;
    found.far += coarse[i] / count;
    found.error += (coarse[i] - means[i]) * (coarse[i] - means[i]) / count;
  }
  found.error = std::sqrt(found.error);
  std::printf("mean %.3f from afar, %.3f near; a pixel %.3f off\n", found.far, found.near, found.error);
  return found;
}

class SpecularAliasingTest : public testing::Test {
protected:
  void TearDown() override {
    for (const std::string& message : gpu_.instance.messages()) ADD_FAILURE() << message;
  }

  test::Gpu gpu_ = test::make_gpu("llvmpipe");
};

TEST_F(SpecularAliasingTest, ReliefTooFineToBeSeenStillSpreadsWhatIsMirrored) {
  VisualDesc desc = square();
  Texture relief{"relief", 64, 64, {}, false};
  std::minstd_rand random(1);
  std::normal_distribution<float> lean(0.0F, 0.2F);
  for (int i = 0; i < 64 * 64; ++i) {
    const glm::vec3 n = glm::normalize(glm::vec3(lean(random), lean(random), 1.0F));
    for (int k = 0; k < 3; ++k)
      relief.rgba.push_back(static_cast<std::uint8_t>(std::lround(127.5F * (n[k] + 1.0F))));
    relief.rgba.push_back(255);
  }
  desc.textures = {relief};
  desc.materials[0].detail.emplace().layers[SurfaceDetail::normal].emplace().nearest = true;
  const Seen found = seen(*gpu_.device, desc);
  EXPECT_LT(found.near, 0.7) << "or there is nothing to see";
  EXPECT_NEAR(found.far, found.near, 0.1);
  EXPECT_LT(found.error, 0.15);
}

TEST_F(SpecularAliasingTest, RidgesOfFewPixelsDoNotSparkle) {
  VisualDesc desc = square();
  Mesh& mesh = desc.meshes[0];
  for (std::size_t i = 0; i < mesh.normals.size(); ++i) {
    const std::size_t column = i / 2;
    const float lean = 0.5F * std::sin(0.125F * std::numbers::pi_v<float> * static_cast<float>(column));
    mesh.normals[i] = glm::normalize(glm::vec3(lean, 0.0F, 1.0F));
  }
  const Seen found = seen(*gpu_.device, desc);
  EXPECT_LT(found.near, 0.8) << "or there is nothing to see";
  EXPECT_LT(found.error, 0.15);
}

}  // namespace
}  // namespace fulcrum::render
