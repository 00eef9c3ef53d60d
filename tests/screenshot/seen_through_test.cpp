// What is behind something is seen through it: which pane is before which, and how much light passes. Drawn
// with the validation layers watching.

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <filesystem>
#include <glm/ext/matrix_transform.hpp>
#include <utility>

#include "engine/render/look.h"
#include "image_compare.h"
#include "pane_scene.h"
#include "surface_balls.h"

namespace fulcrum::render {
namespace {

class SeenThroughTest : public test::PaneTest {
protected:
  // Materials through which a third is seen.
  static VisualDesc red_and_blue() {
    VisualDesc desc = test::pane_scene();
    desc.materials = {{"red", {1, 0, 0}, 0.0F, 0.6F, SurfaceDetail{}},
                      {"blue", {0, 0, 1}, 0.0F, 0.6F, SurfaceDetail{}}};
    for (Material& material : desc.materials) {
      material.detail->alpha = Alpha::blend;
      material.detail->opacity = 0.7F;
      material.detail->unlit = material.detail->double_sided = true;
    }
    return desc;
  }
};

TEST_F(SeenThroughTest, WhatIsSeenThroughLiesBehind) {
  VisualDesc desc = red_and_blue();
  desc.instances = {{0, 0, "red", glm::translate(glm::mat4(1.0F), {0, 0, 0.01F})}, {0, 1, "blue"}};
  const auto red_before = test::mean(draw(desc), 0.4F, 0.4F, 0.6F, 0.6F);
  EXPECT_GT(red_before.r, red_before.b + 20);
  EXPECT_GT(red_before.b, red_before.g + 10) << "blue shines through";
  desc.camera.eye = {0, 0, -0.3F};
  const auto blue_before = test::mean(draw(desc), 0.4F, 0.4F, 0.6F, 0.6F);
  EXPECT_GT(blue_before.b, blue_before.r + 20);
  EXPECT_GT(blue_before.r, blue_before.g + 10);
}

// Red lies before blue wherever the middles of both are, and whichever of the eyes looks.
TEST_F(SeenThroughTest, WhatIsNearerIsDrawnLast) {
  VisualDesc desc = red_and_blue();
  const auto is_red_over_blue = [&] {
    const glm::vec3 c = test::mean(draw(desc), 0.45F, 0.45F, 0.55F, 0.55F);
    return c.r > c.b + 20 && c.b > c.g + 10;
  };
  const glm::mat4 wide = glm::scale(glm::translate(glm::mat4(1.0F), {0.4F, 0, 0.01F}), {10, 10, 1});
  desc.instances = {{0, 0, "red", wide}, {0, 1, "blue"}};
  EXPECT_TRUE(is_red_over_blue()) << "its middle is farther away";
  const auto beside = [](float x, float z) { return glm::translate(glm::mat4(1.0F), {x, 0, z}); };
  desc.instances = {{0, 0, "red", beside(-0.03F, 0)}, {0, 1, "blue", beside(0.03F, -0.0005F)}};
  for (const float eye : {-0.03F, 0.03F}) {
    desc.camera.eye.x = eye;
    EXPECT_TRUE(is_red_over_blue()) << "seen from " << eye;
  }
  // One in the other, in whatever order the file has them; and the far wall of what the eye is in.
  desc.camera.eye.x = 0;
  desc.meshes = {test::make_box(glm::vec3(0.05F)), test::make_box(glm::vec3(0.02F))};
  desc.instances = {{0, 0, "red"}, {1, 1, "blue"}};
  EXPECT_TRUE(is_red_over_blue());
  std::swap(desc.instances[0], desc.instances[1]);
  EXPECT_TRUE(is_red_over_blue());
  desc.instances = {{1, 0, "red"}, {0, 1, "blue", glm::scale(glm::mat4(1.0F), glm::vec3(8))}};
  EXPECT_TRUE(is_red_over_blue());
}

// A pane that was turned before it was exported, by half a right angle: as seen from near, from within the
// box along the world's axes that is around it; and from afar, what hangs before it within that box.
TEST_F(SeenThroughTest, ASlantedPaneHasItsOrderFromAnywhere) {
  VisualDesc desc = red_and_blue();
  const glm::vec3 normal = glm::normalize(glm::vec3(0, 1, 1));
  Mesh slanted = test::pane();
  for (glm::vec3& p : slanted.positions)
    p = glm::vec3(glm::rotate(glm::mat4(1.0F), -glm::radians(45.0F), {1, 0, 0}) * glm::vec4(6.0F * p, 1.0F));
  slanted.normals.assign(4, normal);
  desc.meshes = {slanted, test::make_box(glm::vec3(0.02F))};
  const auto shown = [&](const glm::vec3& eye, const glm::vec3& vial) {
    desc.camera = {eye, vial, 0.15F};
    desc.instances = {{0, 0, "red"}, {1, 1, "blue", glm::translate(glm::mat4(1.0F), vial)}};
    const glm::vec3 c = test::mean(draw(desc), 0.45F, 0.45F, 0.55F, 0.55F);
    return c.r - c.b;
  };
  EXPECT_GT(shown(0.2F * normal, -0.1F * normal), 20) << "the vial is behind it";
  EXPECT_LT(shown({0, 0, 0.5F}, {0, 0, 0.15F}), -20) << "the vial is before it";
}

// A pane of two sides, whose own order in the mesh is front, back: the near one is seen.
TEST_F(SeenThroughTest, TheNearSideOfWhatIsBlendedIsDrawnLast) {
  VisualDesc desc = test::pane_scene();
  Mesh both = test::pane();
  for (std::size_t i = 0; i < 4; ++i) {  // the back looks away; the front is red, the back green
    both.positions.push_back(both.positions[i] - glm::vec3(0, 0, 0.02F));
    both.normals.emplace_back(0, 0, -1);
    both.uv.emplace_back(0.75F, 0.25F, 0, 0);
  }
  for (std::size_t i = 0; i < 4; ++i) both.uv[i] = {0.25F, 0.25F, 0, 0};
  both.indices.insert(both.indices.end(), {4, 5, 6, 4, 6, 7});
  desc.meshes = {both};
  desc.textures = {test::four_colours()};
  SurfaceDetail& detail = *desc.materials[0].detail;
  detail.layers[SurfaceDetail::base_colour] = TextureLayer{.nearest = true};
  detail.alpha = Alpha::blend;
  detail.double_sided = detail.unlit = true;
  EXPECT_EQ(corners(draw(desc)), "rrrr");
  desc.camera.eye = {0, 0, -0.3F};
  EXPECT_EQ(corners(draw(desc)), "gggg");
}

// A thin wall of glass before a red one: red is seen as before, but for what the glass mirrors.
TEST_F(SeenThroughTest, GlassShowsWhatIsBehind) {
  VisualDesc desc = test::pane_scene();
  desc.meshes.push_back(test::make_box({0.2F, 0.2F, 0.01F}));
  desc.materials.push_back({"wall", {0.6F, 0.01F, 0.01F}, 0.0F, 0.9F});
  desc.instances.push_back({1, 1, "wall", glm::translate(glm::mat4(1.0F), {0, 0, -0.06F})});
  const auto red = [&] { return test::mean(draw(desc), 0.4F, 0.4F, 0.6F, 0.6F); };
  EXPECT_LT(red().r, 1.2F * red().g) << "a white pane hides it";
  desc.materials[0].detail->transmission = 1.0F;
  EXPECT_GT(red().r, 2.0F * red().g);
  desc.materials[0].base_colour = glm::vec3(0.1F);
  const glm::vec3 through_dark = red();
  desc.materials[0].base_colour = glm::vec3(1.0F);
  EXPECT_GT(red().r, through_dark.r + 30) << "dark glass lets less through";
}

// glTF: what a metal does not mirror it absorbs, so that it hides, and throws a shadow.
TEST_F(SeenThroughTest, NothingPassesThroughMetal) {
  VisualDesc desc = test::pane_scene();
  desc.meshes.push_back(test::make_box({0.2F, 0.2F, 0.01F}));
  desc.materials.push_back({"wall", {0.6F, 0.01F, 0.01F}, 0.0F, 0.9F});
  desc.instances.push_back({1, 1, "wall", glm::translate(glm::mat4(1.0F), {0, 0, -0.06F})});
  Material& material = desc.materials[0];
  material.metallic = 1.0F;
  const Picture metal = draw(desc);
  material.detail->transmission = 1.0F;
  EXPECT_EQ(draw(desc).rgba, metal.rgba);
  EXPECT_FALSE(is_blended(look_of(material).value()));
  EXPECT_TRUE(throws_shadow(desc.instances[0], material));
  material.metallic = 0.5F;
  EXPECT_TRUE(is_blended(look_of(material).value()));
  material.metallic = 1.0F;
  material.detail->layers[SurfaceDetail::metal_rough].emplace();
  EXPECT_TRUE(is_blended(look_of(material).value())) << "its picture may say otherwise";
}

// KHR_materials_sheen: what is below fibres is darker by what they send on, which is the integral of their
// lobe: at roughness 1, seen from straight above, sqrt(2) / 10.
TEST_F(SeenThroughTest, FibresOnGlassTakeTheirPart) {
  VisualDesc desc = test::pane_scene();
  desc.meshes.push_back(test::make_box({0.2F, 0.2F, 0.01F}));
  desc.materials.push_back({"wall", glm::vec3(0.3F), 0.0F, 0.9F, SurfaceDetail{}});
  desc.materials[1].detail->unlit = true;
  desc.instances.push_back({1, 1, "wall", glm::translate(glm::mat4(1.0F), {0, 0, -0.06F})});
  desc.ambient.intensity = 0.0F;
  Material& glass = desc.materials[0];
  glass.detail->transmission = 1.0F;
  const float clear = brightness(draw(desc));
  glass.base_colour = glm::vec3(1.0F - 0.1F * std::sqrt(2.0F));
  const float darker = brightness(draw(desc));
  EXPECT_LT(darker, clear - 10);
  glass.base_colour = glm::vec3(1.0F);
  glass.detail->sheen = glm::vec3(1.0F);
  glass.detail->sheen_roughness = 1.0F;
  EXPECT_NEAR(brightness(draw(desc)), darker, 2.0F);
}

// Half of the light behind thick glass is what is behind thin glass of half the colour: to the pixel.
TEST_F(SeenThroughTest, ThickGlassIsDarkerByWhatItsVolumeTakes) {
  VisualDesc desc = test::pane_scene();
  desc.meshes.push_back(test::make_box({0.2F, 0.2F, 0.01F}));
  desc.materials.push_back({"wall", {0.6F, 0.5F, 0.4F}, 0.0F, 0.9F});
  desc.instances.push_back({1, 1, "wall", glm::translate(glm::mat4(1.0F), {0, 0, -0.06F})});
  Material& glass = desc.materials[0];
  glass.detail->transmission = 1.0F;
  glass.base_colour = glm::vec3(0.5F);
  const Picture thin = draw(desc);
  glass.base_colour = glm::vec3(1.0F);
  const float clear = brightness(draw(desc));
  glass.detail->passed = glm::vec3(0.5F);
  const Picture thick = draw(desc);
  EXPECT_EQ(thick.rgba, thin.rgba);
  EXPECT_LT(brightness(thick), clear - 60);
}

// A wall behind coloured glass looks as one of the colours' product does behind clear glass. The wall is
// dark, so that the range which the picture's colours are pressed into hardly bends them.
TEST_F(SeenThroughTest, EachColourPassesByItself) {
  VisualDesc desc = test::pane_scene();
  desc.meshes.push_back(test::make_box({0.2F, 0.2F, 0.01F}));
  desc.materials.push_back({"wall", glm::vec3(0.08F), 0.0F, 0.9F, SurfaceDetail{}});
  desc.materials[1].detail->unlit = true;
  desc.instances.push_back({1, 1, "wall", glm::translate(glm::mat4(1.0F), {0, 0, -0.06F})});
  SurfaceDetail& glass = *desc.materials[0].detail;
  glass.transmission = 1.0F;
  glass.f0 = glm::vec3(0.0F);  // it mirrors nothing
  glass.f90 = 0.0F;
  const glm::vec3 amber(0.9F, 0.4F, 0.1F);
  for (const int samples : {1, 4}) {
    const auto seen = [&](const glm::vec3& wall, const glm::vec3& passed) {
      desc.materials[1].base_colour = wall;
      desc.materials[0].detail->passed = passed;
      return test::mean(draw(desc, {samples, 512, 1.0F}), 0.4F, 0.4F, 0.6F, 0.6F);
    };
    const glm::vec3 grey(0.08F), clear(1.0F), through_amber = seen(grey, amber),
                                              wanted = seen(grey * amber, clear);
    EXPECT_GT(glm::distance(seen(grey, clear), through_amber), 60.0F);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(through_amber[i], wanted[i], 3.0F) << "of colour " << i;
  }
}

// Clear glass, and glass that a centimetre of its colour has darkened, and three.
TEST_F(SeenThroughTest, BallsOfDeeperAndDeeperGlass) {
  VisualDesc desc = test::surface_balls();
  desc.instances.erase(desc.instances.begin(), desc.instances.begin() + 10);
  Material glass{"glass", glm::vec3(1.0F), 0.0F, 0.03F, SurfaceDetail{}};
  glass.detail->transmission = 1.0F;
  for (std::size_t i = 0; i < 3; ++i) {
    desc.instances.push_back(
        {0, desc.materials.size(), "ball",
         glm::translate(glm::mat4(1.0F), {0.12F * (static_cast<float>(i) - 1.0F), 0.04F, 0.0F})});
    desc.materials.push_back(glass);
    glass.detail->passed = i == 0 ? glm::vec3(0.5F, 0.6F, 0.4F) : glm::vec3(0.125F, 0.216F, 0.064F);
  }
  const Picture picture = draw(desc, {4, 1024, 1.0F}, {480, 270});
  const test::Comparison result =
      test::compare(picture, std::filesystem::path(FULCRUM_GOLDENS) / "volume.png",
                    {.max_lsb = 2, .max_pixels = 20, .failure_folder = FULCRUM_FAILURES});
  EXPECT_TRUE(result.passed) << result.sentence;
}

}  // namespace
}  // namespace fulcrum::render
