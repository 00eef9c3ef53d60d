// Textures, holes and layers, drawn with the validation layers watching. What is to be seen is known on
// paper: which corner of a picture lies where, which slope faces the light.

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <glm/ext/matrix_transform.hpp>

#include "engine/render/frame_data.h"
#include "engine/render/look.h"
#include "engine/render/scene_geometry.h"
#include "image_compare.h"
#include "pane_scene.h"
#include "surface_balls.h"

namespace fulcrum::render {
namespace {

using test::flat;
using test::four_colours;
using test::pane;
using test::pane_scene;

class DetailedSurfacesTest : public test::PaneTest {};

TEST_F(DetailedSurfacesTest, ADetailOfNothingLooksPlain) {
  VisualDesc desc = test::make_scene();
  const Picture plain = draw(desc, {4, 512, 1.0F}, {320, 180});
  for (Material& material : desc.materials) material.detail = SurfaceDetail{};
  const Picture detailed = draw(desc, {4, 512, 1.0F}, {320, 180});
  const test::Comparison result = test::compare(
      plain, detailed, {.max_lsb = 1, .max_pixels = 40, .max_share_by_one = 0.003, .failure_folder = {}});
  EXPECT_TRUE(result.passed) << result.sentence;
}

TEST_F(DetailedSurfacesTest, ATextureLiesAsItsCoordinatesSay) {
  VisualDesc desc = pane_scene();
  desc.textures = {four_colours()};
  SurfaceDetail& detail = *desc.materials[0].detail;
  detail.unlit = true;
  TextureLayer& layer = detail.layers[SurfaceDetail::base_colour].emplace();
  layer.nearest = true;
  EXPECT_EQ(corners(draw(desc)), "rgwb");
  layer.shift = {0.5F, 0.0F};  // the next column, round the edge
  EXPECT_EQ(corners(draw(desc)), "grbw");
  layer.wrap_u = Wrap::clamp;
  EXPECT_EQ(corners(draw(desc)), "ggww");
  layer = {.nearest = true};
  layer.turn = glm::mat2(0, -1, 1, 0);  // u' = v, v' = -u: a quarter of a turn
  EXPECT_EQ(corners(draw(desc)), "brgw") << "the coordinates turn to the left, the picture to the right";
  layer = {.uv_set = 1, .nearest = true};
  for (glm::vec4& uv : desc.meshes[0].uv) uv = {0, 0, 1 - uv.x, uv.y};
  EXPECT_EQ(corners(draw(desc)), "grbw");
}

// A mesh of wires is as dense from far away as from nearby, whatever the samples and however thin they are.
TEST_F(DetailedSurfacesTest, AMeshOfWiresIsAsDenseFromFarAway) {
  VisualDesc desc = pane_scene();
  const auto wires = [](int thick) {
    Texture made{"wires", 16, 16, {}, true, true, 0.5F};
    for (int y = 0; y < 16; ++y)
      for (int x = 0; x < 16; ++x) {
        const std::uint8_t alpha = x < thick || y < thick ? 180 : 40;
        made.rgba.insert(made.rgba.end(), {255, 255, 255, alpha});
      }
    return made;
  };
  desc.textures = {wires(4)};
  SurfaceDetail& detail = *desc.materials[0].detail;
  detail.unlit = true;
  detail.layers[SurfaceDetail::base_colour].emplace();
  desc.materials[0].base_colour = glm::vec3(0.5F);
  // Radiance in the mean of the middle.
  const auto light = [&](const VisualDesc& of, const Quality& quality) {
    const Picture picture = draw(of, quality);
    double sum = 0;
    for (std::size_t y = 72; y < 108; ++y)
      for (std::size_t x = 72; x < 108; ++x) sum += test::radiance_of(picture.rgba[4 * (180 * y + x) + 1]);
    return sum / (36 * 36);
  };
  const auto light_of_all = [&](const Quality& quality, std::uint8_t alpha) {
    VisualDesc all = desc;
    all.textures[0].rgba.assign(all.textures[0].rgba.size(), alpha);
    return light(all, quality);
  };
  detail.alpha = Alpha::mask;
  for (const int samples : {1, 4}) {
    const Quality quality{samples, 512, 1.0F};
    const double all = light_of_all(quality, 255), none = light_of_all(quality, 0);
    for (const int thick : {1, 4})
      for (const float meshes : {10.0F, 20.0F, 40.0F, 110.0F, 400.0F}) {
        desc.textures = {wires(thick)};
        desc.meshes[0] = pane();
        for (glm::vec4& uv : desc.meshes[0].uv) uv *= meshes;
        const double part = (light(desc, quality) - none) / (all - none);
        const double open = (16 - thick) / 16.0;
        EXPECT_NEAR(part, 1 - open * open, 0.07)
            << samples << " samples, " << meshes << " meshes, " << thick << " thick";
      }
  }
}

// glTF 2.0: what is as high as the cut-off is there, all of it.
TEST_F(DetailedSurfacesTest, WhatIsAsHighAsTheCutOffIsThere) {
  for (const int samples : {1, 4})
    for (const float cut : {0.0F, 0.5F, 1.0F}) {
      VisualDesc desc = pane_scene();
      const auto alpha = static_cast<std::uint8_t>(cut == 0.0F ? 0 : 255);
      desc.textures = {flat({255, 255, 255, alpha})};
      SurfaceDetail& detail = *desc.materials[0].detail;
      detail.unlit = true;
      detail.layers[SurfaceDetail::base_colour].emplace();
      const Quality quality{samples, 512, 1.0F};
      const float whole = brightness(draw(desc, quality));
      detail.alpha = Alpha::mask;
      detail.alpha_cutoff = cut;
      detail.opacity = std::max(cut, 0.5F);
      desc.textures[0].cut_off = cut / detail.opacity;
      EXPECT_NEAR(brightness(draw(desc, quality)), whole, 0.5F) << samples << " samples, " << cut;
    }
}

// A slope towards the light is brighter than the flat pane, and one away from it darker, on each axis,
// whichever way the coordinates run; from behind, a slope is the other way about.
TEST_F(DetailedSurfacesTest, ANormalMapSlopesAsItsColoursSay) {
  VisualDesc desc = pane_scene();
  desc.textures = {flat({128, 128, 255, 255}, false)};
  SurfaceDetail& detail = *desc.materials[0].detail;
  detail.layers[SurfaceDetail::normal].emplace();
  detail.double_sided = true;
  desc.key_light.emplace();
  desc.ambient.intensity = 0.0F;
  const auto slope = [&](std::uint8_t red, std::uint8_t green) {
    desc.textures[0] = flat({red, green, 220, 255}, false);
    return brightness(draw(desc));
  };
  for (const bool behind : {false, true}) {
    const float side = behind ? -1.0F : 1.0F;  // seen from there, +x is at the left
    desc.camera.eye = {0, 0, 0.3F * side};
    for (const bool mirrored : {false, true}) {
      desc.meshes[0] = pane();
      for (glm::vec4& uv : desc.meshes[0].uv) uv.x = mirrored ? 1.0F - uv.x : uv.x;
      const bool red_leans_to_x = mirrored == behind, green_leans_up = !behind;
      desc.key_light->direction = {-1, 0, -side};  // from +x and the eye
      const float flat_x = slope(128, 128);
      EXPECT_GT(slope(red_leans_to_x ? 190 : 66, 128), flat_x + 5) << behind << mirrored;
      EXPECT_LT(slope(red_leans_to_x ? 66 : 190, 128), flat_x - 5) << behind << mirrored;
      desc.key_light->direction = {0, -1, -side};  // from above
      const float flat_y = slope(128, 128);
      EXPECT_GT(slope(128, green_leans_up ? 190 : 66), flat_y + 5) << behind << mirrored;
      EXPECT_LT(slope(128, green_leans_up ? 66 : 190), flat_y - 5) << behind << mirrored;
    }
  }
}

TEST_F(DetailedSurfacesTest, OneSidedPanesAreNotSeenFromBehind) {
  VisualDesc desc = pane_scene();
  desc.materials[0].detail->emission = glm::vec3(1.0F);
  const float before = brightness(draw(desc));
  desc.camera.eye = {0, 0, -0.3F};
  const float behind = brightness(draw(desc));
  EXPECT_LT(behind, 0.6F * before);
  desc.materials[0].detail->double_sided = true;
  EXPECT_NEAR(brightness(draw(desc)), before, 0.1F * before);
}

// The left half is not there: neither in the picture nor in the shadow on the wall behind.
TEST_F(DetailedSurfacesTest, WhatIsCutOutIsNotSeenAndThrowsNoShadow) {
  VisualDesc desc = pane_scene();
  desc.textures = {{"half", 2, 1, {255, 0, 0, 0, 255, 0, 0, 255}, true}};
  SurfaceDetail& detail = *desc.materials[0].detail;
  detail.alpha = Alpha::mask;
  detail.layers[SurfaceDetail::base_colour] = TextureLayer{.nearest = true};
  desc.meshes.push_back(test::make_box({0.5F, 0.5F, 0.01F}));
  desc.materials.push_back({"wall", glm::vec3(0.5F), 0.0F, 0.9F});
  desc.instances.push_back({1, 1, "wall", glm::translate(glm::mat4(1.0F), {0, 0, -0.06F}), false, false});
  desc.key_light.emplace();
  desc.key_light->direction = {0, -1, -1};  // the shadow falls 5 cm lower
  const Picture picture = draw(desc, {1, 1024, 1.0F});
  const auto at = [&](float x, float y) {
    return test::mean(picture, x - 0.04F, y - 0.04F, x + 0.04F, y + 0.04F);
  };
  EXPECT_LT(at(0.35F, 0.4F).r, 1.3F * at(0.35F, 0.4F).g) << "the wall is seen through the hole";
  EXPECT_GT(at(0.65F, 0.4F).r, 2.0F * at(0.65F, 0.4F).g) << "red is there";
  EXPECT_LT(at(0.63F, 0.89F).g, at(0.37F, 0.89F).g - 30) << "its shadow, and none beside it";
}

// glTF 2.0, 3.9.3: both directions of a map's frame have unit length, and u grows along one of them alone.
TEST_F(DetailedSurfacesTest, ASlopeIsAsSteepHoweverAPictureIsStretchedOrSheared) {
  VisualDesc desc = pane_scene();
  desc.key_light.emplace();
  desc.key_light->direction = {-1, -0.5F, -1};
  desc.ambient.intensity = 0.0F;
  desc.materials[0].detail->layers[SurfaceDetail::normal].emplace();
  for (const std::array<std::uint8_t, 4> lean :
       {std::array<std::uint8_t, 4>{200, 128, 220, 255}, std::array<std::uint8_t, 4>{128, 190, 220, 255},
        std::array<std::uint8_t, 4>{90, 100, 230, 255}}) {
    desc.textures = {flat(lean, false)};
    desc.meshes[0] = pane();
    const float even = brightness(draw(desc));
    for (const glm::vec3& grown : {glm::vec3(5, 1, 0), glm::vec3(1, 5, 0), glm::vec3(0.1F, 1, 0),
                                   glm::vec3(1, 1, 0.7F), glm::vec3(1, 0.2F, -2)}) {
      desc.meshes[0] = pane();
      for (glm::vec4& uv : desc.meshes[0].uv) uv = {grown.x * uv.x + grown.z * uv.y, grown.y * uv.y, 0, 0};
      EXPECT_NEAR(brightness(draw(desc)), even, 3.0F)
          << grown.x << ' ' << grown.y << ' ' << grown.z << ' ' << int{lean[0]};
    }
  }
}

// A wall that faces away from the light is in its own shadow, wherever its relief leans.
TEST_F(DetailedSurfacesTest, NoLightGetsThroughASurfaceToASlope) {
  VisualDesc desc = pane_scene();
  desc.key_light.emplace();
  desc.ambient.intensity = 0.0F;
  desc.textures = {flat({235, 128, 180, 255}, false)};
  desc.materials[0].detail->layers[SurfaceDetail::normal].emplace();
  desc.key_light->direction = {-1, 0, -0.5F};
  EXPECT_GT(brightness(draw(desc)), 100) << "it leans to this light";
  desc.key_light->direction = {-1, 0, 0.1F};  // from behind
  EXPECT_LT(brightness(draw(desc)), 1);
  desc.key_light.reset();
  PunctualLight lamp;
  lamp.position = {1, 0, -0.1F};
  lamp.colour = glm::vec3(10.0F);
  desc.lights = {lamp};
  EXPECT_LT(brightness(draw(desc)), 1);
  desc.lights[0].position.z = 0.5F;
  EXPECT_GT(brightness(draw(desc)), 100);
}

// Each layer does something, and what it does has the right sign.
TEST_F(DetailedSurfacesTest, LayersLighten) {
  VisualDesc desc = pane_scene();
  desc.materials[0].base_colour = glm::vec3(0.02F);
  desc.key_light.emplace();
  desc.key_light->direction = {0, 0, -1};  // mirrored into the eye
  const float plain = brightness(draw(desc));
  const auto with = [&](auto change) {
    VisualDesc changed = desc;
    change(*changed.materials[0].detail);
    return brightness(draw(changed));
  };
  EXPECT_GT(with([](SurfaceDetail& d) {
              d.clearcoat = 1.0F;
              d.clearcoat_roughness = 0.3F;
            }),
            plain + 20);
  EXPECT_GT(with([](SurfaceDetail& d) { d.f0 = glm::vec3(0.2F); }), plain + 20)
      << "a higher index of refraction";
  EXPECT_LT(with([](SurfaceDetail& d) {
              d.f0 = glm::vec3(0.0F);
              d.f90 = 0.0F;
            }),
            plain - 10)
      << "no specular";
  EXPECT_GT(with([](SurfaceDetail& d) { d.emission = glm::vec3(0.5F); }), plain + 50);
  desc.instances[0].X_WM =
      glm::rotate(glm::mat4(1.0F), -1.3F, {1, 0, 0});  // nearly edge on: where fibres shine
  const auto fibres = [](SurfaceDetail& d) {
    d.sheen = glm::vec3(1.0F);
    d.sheen_roughness = 0.8F;
  };
  EXPECT_GT(with(fibres), brightness(draw(desc)) + 20);
}

TEST_F(DetailedSurfacesTest, ABallForEachOfThem) {
  const Picture picture = draw(test::surface_balls(), {4, 1024, 1.0F}, {640, 360});
  const test::Comparison result =
      test::compare(picture, std::filesystem::path(FULCRUM_GOLDENS) / "surfaces.png",
                    {.max_lsb = 2, .max_pixels = 20, .failure_folder = FULCRUM_FAILURES});
  EXPECT_TRUE(result.passed) << result.sentence;
}

TEST_F(DetailedSurfacesTest, NothingIsBuiltForWhatNoMaterialHas) {
  const VisualDesc plain = test::make_scene();
  const auto planned = plan(plain, RenderOptions{});
  ASSERT_TRUE(planned);
  EXPECT_TRUE(planned->looks.empty());
  for (const BuildItem& item : planned->built) EXPECT_NE(item.name, "detailed surfaces");
  VisualDesc desc = pane_scene();
  desc.textures = {four_colours(), four_colours()};
  desc.materials[0].detail->layers[SurfaceDetail::base_colour] = TextureLayer{};
  const auto detailed = plan(desc, RenderOptions{});
  ASSERT_TRUE(detailed);
  EXPECT_EQ(detailed->looks.size(), 1U);
  EXPECT_FALSE(detailed->plain_surfaces);
  std::uint64_t texture_bytes = 0;
  for (const BuildItem& item : detailed->built) texture_bytes += item.name == "textures" ? item.bytes : 0;
  EXPECT_EQ(texture_bytes, 4U * (2 * 2 + 1)) << "of the two textures one is shown, in two sizes";
  const auto has_places = [](const RenderPlan& of) {
    return std::ranges::any_of(of.built,
                               [](const BuildItem& item) { return item.name == "places in textures"; });
  };
  EXPECT_TRUE(has_places(*detailed));
  desc.materials[0].detail = SurfaceDetail{};
  desc.materials[0].detail->clearcoat = 1.0F;
  const auto coated = plan(desc, RenderOptions{});
  ASSERT_TRUE(coated);
  EXPECT_EQ(coated->looks.size(), 1U);
  EXPECT_FALSE(has_places(*coated)) << "no texture lies on it";
  desc.materials[0].detail = SurfaceDetail{};
  desc.materials[0].detail->alpha = Alpha::mask;
  const auto whole = plan(desc, RenderOptions{});
  ASSERT_TRUE(whole);
  EXPECT_FALSE(has_places(*whole)) << "it is cut out nowhere";
  for (const BuildItem& item : whole->built) EXPECT_NE(item.name, "shadows with holes");
  desc.materials[0].detail->opacity = 0.25F;
  EXPECT_FALSE(throws_shadow(desc.instances[0], desc.materials[0]));
  VisualDesc nothing = desc;
  nothing.instances.clear();
  EXPECT_EQ(draw(desc).rgba, draw(nothing).rgba) << "none of it is there";
}

TEST_F(DetailedSurfacesTest, WrongTexturesAreRefusedWithASentence) {
  VisualDesc desc = pane_scene();
  desc.materials[0].detail->layers[SurfaceDetail::base_colour] = TextureLayer{};
  auto refused = plan(desc, RenderOptions{});
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().sentence, "The material 0 (pane) shows texture 0, but there are 0 textures.");
  desc.textures = {{"torn", 4, 4, {1, 2, 3}, true}};
  refused = plan(desc, RenderOptions{});
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence.find("The texture 0 (torn)"), std::string::npos);
}

// What it hides need not be shaded. Blended surfaces come afterwards.
TEST_F(DetailedSurfacesTest, TheNearestIsDrawnFirstWhateverItIsMadeOf) {
  VisualDesc desc = test::pane_scene();
  desc.meshes.assign(4, test::pane());
  SurfaceDetail lacquer, felt, glass;
  lacquer.clearcoat = 1.0F;
  felt.sheen = glm::vec3(1.0F);
  glass.alpha = Alpha::blend;
  desc.materials = {{"lacquer", glm::vec3(1.0F), 0.0F, 0.6F, lacquer},
                    {"plain", glm::vec3(1.0F), 0.0F, 0.6F, {}},
                    {"felt", glm::vec3(1.0F), 0.0F, 0.6F, felt},
                    {"glass", glm::vec3(1.0F), 0.0F, 0.6F, glass}};
  desc.instances.clear();
  for (std::size_t i = 0; i < 4; ++i)
    desc.instances.push_back({i, i, desc.materials[i].name,
                              glm::translate(glm::mat4(1.0F), {0, 0, 0.01F * static_cast<float>(i)})});
  const SceneGeometry geometry(*gpu_.device, desc);
  std::vector<std::optional<std::size_t>> order;
  for (const SceneGeometry::Draw& draw :
       geometry.opaque({clip_from_world(desc.camera, {180, 180}), desc.camera.eye}))
    order.push_back(draw.of.material);
  EXPECT_EQ(order, (std::vector<std::optional<std::size_t>>{2, std::nullopt, 0}));
}

}  // namespace
}  // namespace fulcrum::render
