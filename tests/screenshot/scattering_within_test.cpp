// Light that spreads below a surface stays within it, and is there in each view of each size.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <limits>

#include "engine/render/tone.h"
#include "half_lit_floor.h"

namespace fulcrum::render {
namespace {

class ScatteringWithinTest : public test::HalfLitFloor {
protected:
  // Of any channel of any pixel, by light that spreads.
  int largest_change(const VisualDesc& desc, int samples) {
    const Picture spread = drawn(desc, quality(16, samples)), plain = drawn(desc, quality(0, samples));
    int most = 0;
    for (std::size_t i = 0; i < spread.rgba.size(); ++i)
      most = std::max(most, std::abs(spread.rgba[i] - plain.rgba[i]));
    return most;
  }
};

TEST_F(ScatteringWithinTest, EvenLightStaysAsItIs) {
  VisualDesc desc = half_lit({0.01F, 0.004F, 0.002F}, 0.1F);
  std::ranges::fill(desc.meshes[0].normals, glm::vec3(0, 1, 0));
  for (const int samples : {1, 4}) EXPECT_LE(largest_change(desc, samples), 1) << samples;
}

// What is unlit stays dark to its last column, and what is lit stays bright, as without.
TEST_F(ScatteringWithinTest, NothingSpreadsOverAStepOfDepth) {
  VisualDesc desc = half_lit(glm::vec3(0.001F), 0.1F);
  for (std::size_t i = 4; i < 8; ++i) desc.meshes[0].positions[i].y = -0.1F;
  EXPECT_EQ(drawn(desc, quality(16)).rgba, drawn(desc, quality(0)).rgba);
}

TEST_F(ScatteringWithinTest, NothingSpreadsFromOneThingToAnother) {
  VisualDesc desc = half_lit(glm::vec3(0.004F), 0.1F);
  Mesh dark;
  add_square(dark, 0.0F, 1.0F, 0.0F, {1, 0, 0});
  for (const std::size_t material : {0U, 1U}) {  // of the same material, and of one of another distance
    VisualDesc two = desc;
    two.meshes[0] = {};
    add_square(two.meshes[0], -1.0F, 0.0F, 0.0F, {0, 1, 0});
    two.meshes.push_back(dark);
    two.materials.push_back(two.materials[0]);
    two.materials[1].detail->scatter_distance = glm::vec3(0.006F);
    two.instances.push_back({1, material, "dark", glm::mat4(1.0F), true, false});
    EXPECT_EQ(drawn(two, quality(16)).rgba, drawn(two, quality(0)).rgba) << material;
  }
}

TEST_F(ScatteringWithinTest, ADistanceOfZeroIsDrawnBitForBitAsWithoutOne) {
  VisualDesc desc = test::make_scene();
  const Picture plain = drawn(desc, kQualityLevels[0]);
  for (Material& material : desc.materials) material.detail.emplace();
  const auto planned = plan(desc, {});
  ASSERT_TRUE(planned);
  EXPECT_EQ(planned->scattering, 0);
  const Picture none = drawn(desc, kQualityLevels[0]);
  EXPECT_EQ(none.rgba, plain.rgba);
  for (Material& material : desc.materials) material.detail->scatter_distance = glm::vec3(0.01F);
  Quality off = kQualityLevels[0];
  off.scattering = 0;
  EXPECT_EQ(drawn(desc, off).rgba, plain.rgba);
  EXPECT_NE(drawn(desc, kQualityLevels[0]).rgba, plain.rgba);
}

// A colour of which none spreads stays sharp while another does not.
TEST_F(ScatteringWithinTest, AColourThatDoesNotSpreadStaysSharp) {
  const Picture plain = drawn(half_lit(glm::vec3(0.0F), 0.1F), quality(16));
  const Picture picture = drawn(half_lit({0.004F, 0.0F, 0.0F}, 0.1F), quality(16));
  EXPECT_GT(at(picture, 160 + 13, 120, 0), at(plain, 160 + 13, 120, 0) + 40);
  EXPECT_LT(at(picture, 160 + 13, 120, 1), at(plain, 160 + 13, 120, 1) + 15);  // tone mapping mixes a little
}

// A tool over flesh hides its light from the eye, not from the flesh beside it.
TEST_F(ScatteringWithinTest, WhatIsBeforeItHidesNothingOfIt) {
  VisualDesc desc = half_lit(glm::vec3(0.004F), 0.1F);
  const Picture alone = drawn(desc, quality(16));
  desc.meshes.push_back(test::make_box({0.01F, 0.001F, 1.0F}));
  desc.materials.push_back({"steel", glm::vec3(0.3F), 0.0F, 1.0F});
  desc.instances.push_back(
      {1, 1, "tool", glm::translate(glm::mat4(1.0F), {-0.0101F, 0.05F, 0}), true, false});
  const Picture with = drawn(desc, quality(16));
  EXPECT_NE(at(with, 140, 120), at(alone, 140, 120));
  for (std::uint32_t x = 161; x < 320; ++x) EXPECT_EQ(at(with, x, 120), at(alone, x, 120)) << x;
}

// A ball before nothing: at its outline samples of it lie in pixels whose middle it does not cover.
TEST_F(ScatteringWithinTest, AnOutlineIsNeitherDarkNorBright) {
  VisualDesc desc = half_lit(glm::vec3(0.0005F), 0.1F);
  desc.meshes = {test::make_ball(0.03F)};
  desc.key_light.reset();
  desc.ambient = {glm::vec3(1.0F), glm::vec3(1.0F), 1.0F};
  desc.background = {glm::vec3(0.4F), glm::vec3(0.4F)};
  for (const int samples : {1, 4}) EXPECT_LE(largest_change(desc, samples), 12) << samples;
}

// Wider than all that is seen, and far less than a pixel: finite light, between what there is.
TEST_F(ScatteringWithinTest, AnyDistanceGivesLightThatThereIs) {
  for (const float d : {1e-7F, 1e-5F, 0.1F, 10.0F}) {
    const Picture picture = drawn(half_lit(glm::vec3(d), 0.1F), quality(16));
    const int lit = at(drawn(half_lit(glm::vec3(0.0F), 0.1F), quality(16)), 20, 120);
    for (std::uint32_t y = 0; y < kSize.height; ++y)
      for (std::uint32_t x = 0; x < kSize.width; ++x) EXPECT_LE(at(picture, x, y), lit + 1);
    EXPECT_GT(at(picture, 20, 120), lit / 4) << d;
    if (d < 1e-4F) EXPECT_NEAR(at(picture, 20, 120), lit, 1) << d;
  }
}

// How far away a surface is is kept coarsely beside its light: seen square on, from wherever, a distance of
// far less than that step gives the light that is there without.
TEST_F(ScatteringWithinTest, ATinyDistanceIsLitFromAnywhere) {
  for (const float away : {0.5F, 0.737F, 0.833F, 1.17F, 1.9F, 3.3F}) {
    const Picture plain = drawn(half_lit(glm::vec3(0.0F), 0.1F, away), quality(16));
    const Picture spread = drawn(half_lit(glm::vec3(1e-5F), 0.1F, away), quality(16));
    EXPECT_GT(at(plain, 20, 120), 100);
    EXPECT_NEAR(at(spread, 20, 120), at(plain, 20, 120), 1) << away;
  }
}

// Stereo, a smaller scene, another size: each is built and drawn, and the layers have nothing to say.
TEST_F(ScatteringWithinTest, EachEyeAndEachSizeHasItsOwn) {
  const VisualDesc desc = half_lit(glm::vec3(0.004F), 0.1F);
  RenderOptions options{kSize, quality(8, 4), {}};
  options.stereo = Stereo{StereoMode::side_by_side};
  options.quality.resolution_scale = 0.5F;
  const auto made = Renderer::create(*gpu_.device, desc, options);
  ASSERT_TRUE(made) << made.error().sentence;
  Renderer& renderer = **made;
  const glm::mat4 still(1.0F);
  FrameState state;
  state.camera = desc.camera;
  state.X_WM = {&still, 1};
  for (const Extent& size : {kSize, Extent{201, 77}, Extent{1, 1}, Extent{640, 360}}) {
    ASSERT_FALSE(renderer.resize(size));
    EXPECT_FALSE(renderer.frame(state));
  }
  const Picture wide = *renderer.read_back();
  for (const std::uint32_t eye : {0U, 320U}) {
    EXPECT_GT(at(wide, eye + 40, 180), at(wide, eye + 280, 180) + 40);
    EXPECT_GT(at(wide, eye + 170, 180), at(wide, eye + 280, 180) + 10);  // beyond the edge
  }
  state.inset = Inset{};
  state.inset->camera = desc.camera;
  state.inset->x = 10, state.inset->y = 10, state.inset->width = 64, state.inset->height = 48;
  EXPECT_FALSE(renderer.frame(state));
  for (const Quality& level : kQualityLevels) {
    EXPECT_FALSE(renderer.set_quality(level));
    EXPECT_FALSE(renderer.frame(state));
  }
}

TEST_F(ScatteringWithinTest, IsOfTheBestLevelsAndOfScenesThatNameIt) {
  VisualDesc desc = test::make_scene();
  const auto of = [&](const Quality& level) { return plan(desc, {kSize, level, {}}); };
  const auto names_it = [](const std::vector<BuildItem>& items) {
    return std::ranges::count(items, std::string("subsurface scattering"), &BuildItem::name);
  };
  EXPECT_EQ(of(kQualityLevels[0])->scattering, 0);
  EXPECT_EQ(names_it(of(kQualityLevels[0])->left_out), 3);
  EXPECT_EQ(names_it(of(kQualityLevels[0])->built), 0);
  desc.materials[1].detail.emplace().scatter_distance = {0.001F, 0, 0};
  EXPECT_GT(of(kQualityLevels[0])->scattering, 0);
  EXPECT_EQ(names_it(of(kQualityLevels[0])->built), 3);
  EXPECT_EQ(of(kQualityLevels.back())->scattering, 0);
  EXPECT_EQ(names_it(of(kQualityLevels.back())->built), 0);
  desc.materials[1].detail->transmission = 1.0F;  // what is seen through is none of these
  EXPECT_EQ(of(kQualityLevels[0])->scattering, 0);
  desc.materials[1].detail->transmission = 0.0F;
  desc.materials[1].metallic = 1.0F;  // metal has no colour below
  EXPECT_EQ(of(kQualityLevels[0])->scattering, 0);
  EXPECT_EQ(names_it(of(kQualityLevels[0])->left_out), 3);
  desc.materials[1].metallic = 0.99F;
  EXPECT_GT(of(kQualityLevels[0])->scattering, 0);
  Quality odd;
  odd.scattering = 65;
  EXPECT_EQ(of(odd).error().sentence,
            "Light cannot spread below surfaces with 65 samples per pixel; use 0 (it does not) to 64.");
  for (const float wrong : {-0.001F, std::nanf(""), std::numeric_limits<float>::infinity()}) {
    desc.materials[1].detail->scatter_distance.g = wrong;
    EXPECT_EQ(
        of(kQualityLevels[0]).error().sentence,
        "The material 1 (red paint) says that light spreads below it by what is no distance; give metres, 0 "
        "or more.");
  }
}

}  // namespace
}  // namespace fulcrum::render
