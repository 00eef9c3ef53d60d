// Light in a grid of voxels against what a place can see of an even sky.

#include "engine/render/light_volume.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <initializer_list>
#include <numbers>
#include <utility>

#include "test_scene.h"
#include "tests/bench/cpu_time.h"

namespace fulcrum::render {
namespace {

glm::vec3 even(const glm::vec3&) {
  return glm::vec3(1.0F);
}

// Faces of one colour, two triangles each: corner, and the edges that leave it; their cross product is
// outwards.
struct Face {
  glm::vec3 corner, along, across;
};

void add(VisualDesc& desc, const std::vector<Face>& faces, const glm::vec3& colour) {
  Mesh mesh;
  for (const Face& face : faces) {
    const auto first = static_cast<std::uint32_t>(mesh.positions.size());
    const glm::vec3 n = glm::normalize(glm::cross(face.along, face.across));
    for (const glm::vec3& p : {face.corner, face.corner + face.along, face.corner + face.along + face.across,
                               face.corner + face.across}) {
      mesh.positions.push_back(p);
      mesh.normals.push_back(n);
    }
    for (const std::uint32_t i : {0U, 1U, 2U, 0U, 2U, 3U}) mesh.indices.push_back(first + i);
  }
  desc.meshes.push_back(mesh);
  desc.materials.push_back({"paint", colour, 0.0F, 1.0F});
  Instance instance;
  instance.mesh = desc.meshes.size() - 1;
  instance.material = desc.materials.size() - 1;
  desc.instances.push_back(instance);
}

// A shaft of that width around the y axis, open above y = 0, with a floor at -depth and a rim around its
// mouth.
VisualDesc shaft(float width, float depth) {
  const float h = 0.5F * width, r = 0.1F;
  VisualDesc desc;
  desc.key_light.reset();
  add(desc,
      {{{-h, -depth, h}, {width, 0, 0}, {0, 0, -width}},
       {{-h, -depth, -h}, {width, 0, 0}, {0, depth, 0}},
       {{h, -depth, h}, {-width, 0, 0}, {0, depth, 0}},
       {{-h, -depth, h}, {0, 0, -width}, {0, depth, 0}},
       {{h, -depth, -h}, {0, 0, width}, {0, depth, 0}},
       {{-r, 0, r}, {2 * r, 0, 0}, {0, 0, h - r}},
       {{-r, 0, -h}, {2 * r, 0, 0}, {0, 0, h - r}},
       {{-r, 0, h}, {r - h, 0, 0}, {0, 0, -width}},
       {{h, 0, h}, {r - h, 0, 0}, {0, 0, -width}}},
      glm::vec3(0.5F));
  return desc;
}

LightVolume volume_of(const VisualDesc& desc, const Surroundings& around = {even},
                      std::uint32_t layers = ~0U) {
  return make_light_volume(desc, layers, around, make_environment(around).irradiance);
}

std::size_t voxel_at(const LightVolume& volume, const glm::vec3& at) {
  const glm::uvec3 cell((at - volume.low) / volume.voxel);
  return (std::size_t{cell.z} * volume.counts.y + cell.y) * volume.counts.x + cell.x;
}

float facing(const glm::vec4& harmonics, const glm::vec3& d) {
  return glm::dot(glm::vec3(harmonics), d) + harmonics.w;
}

// What a small surface sees of a square of that half width, straight above it at that height, weighed by the
// cosine (J. R. Howell, "A Catalog of Radiation Heat Transfer Configuration Factors", B-3, four times).
float share_of_square(float half_width, float height) {
  const float a = half_width / height, root = std::sqrt(1.0F + a * a);
  return 4.0F / std::numbers::pi_v<float> * a / root * std::atan(a / root);
}

TEST(LightVolume, WhereNothingStandsAllIsOpen) {
  VisualDesc desc = test::make_scene();
  for (Instance& instance : desc.instances) instance.movable = true;
  const LightVolume volume = volume_of(desc);
  EXPECT_EQ(volume.counts, glm::uvec3(1U));
  EXPECT_EQ(light_volume_voxels(desc), 1U);
  EXPECT_EQ(volume.open[0], glm::vec4(0, 0, 0, 1));
  EXPECT_EQ(volume.received[0], volume.unhidden);
  EXPECT_NEAR(facing(volume.unhidden, {0, 1, 0}), 1.0F, 0.01F);
}

// Two bands hold the light of half a sphere exactly and that of a narrow hole up to a quarter too low.
TEST(LightVolume, AShaftIsAsDarkAsItIsDeep) {
  for (const float depth : {0.02F, 0.04F, 0.08F, 0.12F}) {
    const LightVolume volume = volume_of(shaft(0.06F, depth));
    const float height = depth - 1.5F * volume.voxel;
    const std::size_t bottom = voxel_at(volume, {0.001F, -height, 0.001F});
    const float wanted = share_of_square(0.03F, height);
    EXPECT_NEAR(facing(volume.received[bottom], {0, 1, 0}), wanted, 0.04F + 0.25F * wanted) << depth;
    EXPECT_LT(facing(volume.open[bottom], {0, -1, 0}), 0.05F) << depth;
    const std::size_t above = voxel_at(volume, {0.09F, 1.5F * volume.voxel, 0.09F});
    EXPECT_NEAR(facing(volume.received[above], {0, 1, 0}), 1.0F, 0.08F) << depth;
  }
}

TEST(LightVolume, DeeperIsDarker) {
  float before = 1.0F;
  for (const float depth : {0.02F, 0.04F, 0.08F, 0.12F}) {
    const LightVolume volume = volume_of(shaft(0.06F, depth));
    const float now =
        facing(volume.received[voxel_at(volume, {0, 1.5F * volume.voxel - depth, 0})], {0, 1, 0});
    EXPECT_LT(now, before);
    before = now;
  }
}

TEST(LightVolume, AWallSendsItsColourOn) {
  VisualDesc desc;
  desc.key_light.reset();
  add(desc, {{{0, 0, 0}, {0.2F, 0, 0}, {0, 0.2F, 0}}}, {0.8F, 0.1F, 0.1F});
  const LightVolume volume = volume_of(desc);
  const glm::vec4 near = volume.sent_on[voxel_at(volume, {0.1F, 0.1F, 1.4F * volume.voxel})];
  EXPECT_NEAR(near.r, 0.8F, 0.15F) << "an open wall in even light is as bright as its colour";
  EXPECT_GT(near.r, 5.0F * near.g);
}

TEST(LightVolume, AWallSendsTheMeanOfItsPictureOn) {
  VisualDesc desc;
  desc.key_light.reset();
  add(desc, {{{0, 0, 0}, {0.2F, 0, 0}, {0, 0.2F, 0}}}, glm::vec3(1.0F));
  desc.textures = {{"stripes", 2, 1, {255, 51, 0, 255, 153, 0, 51, 255}}};
  SurfaceDetail& detail = desc.materials[0].detail.emplace();
  detail.layers[SurfaceDetail::base_colour].emplace();
  const LightVolume volume = volume_of(desc);
  const glm::vec4 near = volume.sent_on[voxel_at(volume, {0.1F, 0.1F, 1.4F * volume.voxel})];
  EXPECT_NEAR(near.r, 0.8F, 0.15F) << "an open wall in even light is as bright as its picture in the mean";
  EXPECT_GT(near.r, 5.0F * near.g);
}

// Sheets one above the other, each of a material of its own whose base colour is texture i % pictures.
VisualDesc painted_sheets(std::size_t count, std::size_t pictures) {
  VisualDesc desc;
  desc.key_light.reset();
  for (std::size_t i = 0; i < count; ++i) {
    add(desc, {{{0, 0.01F * static_cast<float>(i), 0}, {0, 0, 0.2F}, {0.2F, 0, 0}}}, glm::vec3(1.0F));
    desc.materials.back().detail.emplace().layers[SurfaceDetail::base_colour] =
        TextureLayer{.texture = i % pictures};
  }
  return desc;
}

TEST(LightVolume, ReadsThePicturesOfWhatHidesLightAlone) {
  VisualDesc desc = painted_sheets(4, 4);
  for (const std::uint8_t red : std::initializer_list<std::uint8_t>{255, 51, 102, 153})
    desc.textures.push_back({"paint", 1, 1, {red, 0, 0, 255}});
  desc.instances[1].movable = true;
  desc.instances[2].layers = 2;
  desc.materials[3].detail->alpha = Alpha::blend;
  const LightVolume volume = volume_of(desc, {even}, 1);
  ASSERT_EQ(volume.means.size(), 4U);
  ASSERT_TRUE(volume.means[0]);
  EXPECT_FLOAT_EQ(volume.means[0]->r, 1.0F);
  for (std::size_t i = 1; i < 4; ++i) EXPECT_FALSE(volume.means[i]) << i;
}

// An atlas, as exporters make it.
TEST(LightVolume, APictureThatManyMaterialsShareIsReadOnce) {
  VisualDesc desc = painted_sheets(64, 1);
  constexpr std::uint32_t kSide = 4096;
  desc.textures = {{"atlas", kSide, kSide, std::vector<std::uint8_t>(std::size_t{4} * kSide * kSide, 128)}};
  const double many = bench::cpu_us([&] { volume_of(desc); });
  for (std::size_t i = 1; i < desc.materials.size(); ++i) desc.materials[i].detail.reset();
  const double one = bench::cpu_us([&] { volume_of(desc); });
  EXPECT_LT(many, 2.0 * one);
}

TEST(LightVolume, WhatMovesOrIsSeenThroughHidesNothing) {
  VisualDesc desc;
  desc.key_light.reset();
  add(desc, {{{0, 0, 0}, {0, 0, 0.2F}, {0.2F, 0, 0}}}, glm::vec3(0.5F));
  const LightVolume alone = volume_of(desc);
  add(desc, {{{0, 0.03F, 0}, {0.2F, 0, 0}, {0, 0, 0.2F}}}, glm::vec3(0.5F));
  const LightVolume covered = volume_of(desc);
  desc.materials[1].detail.emplace().alpha = Alpha::blend;
  const LightVolume through_glass = volume_of(desc);
  desc.materials[1].detail.reset();
  desc.instances[1].movable = true;
  const LightVolume below_a_tool = volume_of(desc);
  const auto upwards = [](const LightVolume& volume) {
    return facing(volume.received[voxel_at(volume, {0.1F, 1.5F * volume.voxel, 0.1F})], {0, 1, 0});
  };
  EXPECT_LT(upwards(covered), 0.7F * upwards(alone));
  EXPECT_EQ(upwards(through_glass), upwards(alone));
  EXPECT_EQ(upwards(below_a_tool), upwards(alone));
}

TEST(LightVolume, AFloorOfAKilometreStillHidesWhatIsBelowIt) {
  VisualDesc desc;
  desc.key_light.reset();
  add(desc, {{{-500, 0, -500}, {0, 0, 1000}, {1000, 0, 0}}}, glm::vec3(0.5F));
  desc.instances[0].casts_shadow = false;
  add(desc, {{{0, 0.04F, 0}, {0, 0, 0.1F}, {0.1F, 0, 0}}}, glm::vec3(0.5F));
  const LightVolume volume = volume_of(desc);
  const glm::vec4 open = volume.open[voxel_at(volume, {-0.01F, 1.5F * volume.voxel, -0.01F})];
  EXPECT_LT(facing(open, {0, -1, 0}), 0.1F);
}

// A model that is cut open for some views is whole for others, and each lets in as much light as it shows.
TEST(LightVolume, EachLayerHasItsOwn) {
  VisualDesc desc;
  desc.key_light.reset();
  add(desc, {{{0, 0, 0}, {0, 0, 0.2F}, {0.2F, 0, 0}}}, glm::vec3(0.5F));
  EXPECT_EQ(light_volume_layers(desc), std::vector<std::uint32_t>{~0U});
  desc.instances[0].layers = 3;
  add(desc, {{{0, 0.03F, 0}, {0.2F, 0, 0}, {0, 0, 0.2F}}}, glm::vec3(0.5F));
  EXPECT_EQ(light_volume_layers(desc), (std::vector<std::uint32_t>{1, 2}));
  const LightVolume covered = volume_of(desc, {even}, 1), open = volume_of(desc, {even}, 2);
  const auto upwards = [](const LightVolume& volume) {
    return facing(volume.received[voxel_at(volume, {0.1F, 1.5F * volume.voxel, 0.1F})], {0, 1, 0});
  };
  EXPECT_LT(upwards(covered), 0.7F);
  EXPECT_GT(upwards(open), 0.9F);
  EXPECT_EQ(light_volume_voxels(desc), covered.open.size() + open.open.size());
}

TEST(LightVolume, StaysFiniteForSheetsSpecksAndLandscapes) {
  for (const auto& [place, size] :
       std::initializer_list<std::pair<glm::vec3, float>>{{glm::vec3(0.0F), 1e-6F},
                                                          {glm::vec3(0.0F), 1.0F},
                                                          {glm::vec3(0.0F), 1e4F},
                                                          {glm::vec3(1.0F), 1e-6F}})
    for (const glm::vec3& shape :
         {glm::vec3(1, 1, 1), glm::vec3(1, 0, 1), glm::vec3(1, 0, 0), glm::vec3(0, 0, 0)}) {
      VisualDesc desc;
      add(desc, {{place, size * shape * glm::vec3(1, 0, 0), size * shape * glm::vec3(0, 1, 1)}},
          glm::vec3(1.0F));
      const LightVolume volume = volume_of(desc, surroundings_of({}));
      EXPECT_EQ(volume.open.size(), std::size_t{volume.counts.x} * volume.counts.y * volume.counts.z);
      EXPECT_EQ(light_volume_voxels(desc), volume.open.size());
      EXPECT_LE(volume.counts.x, 64U);
      for (const auto* voxels : {&volume.open, &volume.received, &volume.sent_on})
        for (const glm::vec4& voxel : *voxels)
          ASSERT_TRUE(std::isfinite(voxel.x + voxel.y + voxel.z + voxel.w)) << size;
    }
}

}  // namespace
}  // namespace fulcrum::render
