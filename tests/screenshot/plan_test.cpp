// What is planned follows the scene, needs no device, and names what is wrong.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/render/scatter_taps.h"
#include "shaders/shared/frame.h"
#include "shaders/shared/light.h"
#include "shaders/shared/material.h"
#include "test_scene.h"

namespace fulcrum::render {
namespace {

const BuildItem* find(const std::vector<BuildItem>& items, const std::string& name, const std::string& kind) {
  const auto found = std::find_if(items.begin(), items.end(), [&](const BuildItem& item) {
    return item.name == name && item.kind == kind;
  });
  return found == items.end() ? nullptr : &*found;
}

RenderPlan planned(const VisualDesc& desc, const RenderOptions& options = {}) {
  Result<RenderPlan> made = plan(desc, options);
  EXPECT_TRUE(made) << (made ? "" : made.error().sentence);
  return *made;
}

std::string complaint(const VisualDesc& desc, const RenderOptions& options = {}) {
  const Result<RenderPlan> made = plan(desc, options);
  return made ? "" : made.error().sentence;
}

TEST(Plan, HoldsEverythingThatAFullSceneShows) {
  RenderOptions everything;
  everything.inset = Extent{320, 200};
  everything.stereo = Stereo{StereoMode::interlaced};
  VisualDesc full = test::make_scene();
  full.textures = {{"grain", 2, 2, std::vector<std::uint8_t>(16, 255), true}};
  full.materials[1].detail.emplace().alpha = Alpha::mask;
  full.materials[1].detail->layers[SurfaceDetail::base_colour].emplace();
  full.materials[0].detail.emplace().scatter_distance = glm::vec3(0.001F);
  full.meshes.front().levels.emplace();
  full.meshes.front().levels->indices = full.meshes.front().indices;
  full.ambient.picture = Panorama{2, 1, {glm::vec3(1.0F), glm::vec3(1.0F)}};
  full.lights.emplace_back();
  everything.quality.resolution_scale = 0.75F;
  const RenderPlan all = planned(full, everything);
  for (const char* pipeline : {"surfaces", "detailed surfaces", "shadows", "shadows with holes", "markers",
                               "ghost depth", "ghost lines", "ghost", "background", "tone mapping",
                               "ambient occlusion", "subsurface scattering", "enlargement", "soft shadows"})
    EXPECT_NE(find(all.built, pipeline, "pipeline"), nullptr) << pipeline;
  EXPECT_TRUE(all.left_out.empty());
  EXPECT_EQ(find(all.built, "shadow map", "image")->bytes, 2048U * 2048U * 4U);
  EXPECT_EQ(find(all.built, "standing shadow map", "image")->bytes, 2048U * 2048U * 4U);
  EXPECT_EQ(find(all.built, "textures", "image")->bytes, 4U * (2 * 2 + 1));
  // Four samples of colour and depth, the scene, the ghost's depth and lines, below surfaces depth and light,
  // twice, and at half the size depth and what it hides, twice.
  EXPECT_EQ(find(all.built, "second view", "image")->bytes,
            320U * 200U * (4U * 8U + 8U + 4U * 4U + 4U + 2U + 4U + 2U * 16U) + 160U * 100U * (4U + 2U * 4U));
  EXPECT_EQ(find(all.built, "scene samples", "image")->bytes, 960U * 540U * 8U * 4U);
  EXPECT_NE(find(all.built, "levels of detail", "buffer"), nullptr);
  EXPECT_EQ(find(all.built, "finished scene", "image")->bytes, (960U + 1280U) * 540U * 4U);
  // As the second view, of the whole picture, and what is tone mapped before it is enlarged.
  EXPECT_EQ(find(all.built, "second eye", "image")->bytes,
            960U * 540U * (4U * 8U + 8U + 4U * 4U + 4U + 2U * 16U) + 1280U * 720U * (4U + 2U) +
                480U * 270U * (4U + 2U * 4U) + (960U + 1280U) * 540U * 4U);
  // Each further view has numbers of its own: of the camera, of lights, samples below surfaces, ghosts'
  // edges.
  const std::uint64_t numbers = sizeof(gpu::FrameData) + sizeof(gpu::LightsData) +
                                kScatterPatterns * 16U * sizeof(glm::vec4) +
                                find(all.built, "ghost", "buffer")->bytes;
  EXPECT_EQ(find(all.built, "second eye", "buffer")->bytes, numbers);
  EXPECT_EQ(find(all.built, "second view", "buffer")->bytes, numbers);
  EXPECT_EQ(find(all.built, "materials", "buffer")->bytes, 2U * sizeof(gpu::MaterialData));
  EXPECT_EQ(find(all.built, "white", "image")->bytes, 4U);
}

// A headset shows its panels by itself.
TEST(Plan, LeavesOutTheScreenLayerWhereNothingLiesAtTheScreen) {
  RenderOptions options;
  options.stereo = Stereo{};
  EXPECT_TRUE(planned(test::make_scene(), options).screen_layer);
  options.at_screen = false;
  const RenderPlan plan = planned(test::make_scene(), options);
  EXPECT_FALSE(plan.screen_layer);
  EXPECT_EQ(find(plan.built, "screen layer", "image"), nullptr);
  EXPECT_NE(find(plan.left_out, "screen layer", "image"), nullptr);
  options.inset = Extent{100, 100};
  EXPECT_NE(complaint(test::make_scene(), options).find("A second view lies at the screen"),
            std::string::npos);
}

TEST(Plan, LeavesOutLevelsAndEnlargementWhereNothingAsksForThem) {
  VisualDesc desc = test::make_scene();
  const RenderPlan plan = planned(desc);
  EXPECT_EQ(plan.coarseness, 0.0F);
  EXPECT_NE(find(plan.left_out, "levels of detail", "buffer"), nullptr);
  EXPECT_NE(find(plan.left_out, "enlargement", "pipeline"), nullptr);
  desc.meshes.front().levels.emplace();
  desc.meshes.front().levels->indices = desc.meshes.front().indices;
  RenderOptions finest;
  finest.quality.coarseness = 0.0F;
  EXPECT_EQ(planned(desc, finest).coarseness, 0.0F);
  // They are there for a quality that changes.
  EXPECT_NE(find(planned(desc, finest).built, "levels of detail", "buffer"), nullptr);
  EXPECT_GT(planned(desc).coarseness, 0.0F);
}

TEST(Plan, BuildsNothingForASecondViewThatNobodyAskedFor) {
  const RenderPlan plan = planned(test::make_scene());
  EXPECT_EQ(find(plan.built, "second view", "image"), nullptr);
  EXPECT_NE(find(plan.left_out, "second view", "image"), nullptr);
}

TEST(Plan, LeavesOutOcclusionWhereTheQualityDoes) {
  RenderOptions options;
  options.quality.occlusion = false;
  const RenderPlan plan = planned(test::make_scene(), options);
  EXPECT_FALSE(plan.occlusion);
  EXPECT_EQ(find(plan.built, "ambient occlusion", "image"), nullptr);
  EXPECT_EQ(find(plan.left_out, "ambient occlusion", "pipeline")->note,
            "the quality setting switches it off");
}

TEST(Plan, LeavesOutTheLightVolumeWhereNothingStands) {
  VisualDesc desc = test::make_scene();
  const RenderPlan standing = planned(desc);
  ASSERT_NE(find(standing.built, "light volume", "image"), nullptr);
  EXPECT_EQ(find(standing.built, "light volume", "image")->bytes, 3U * 8U * facts_of(desc).voxels);
  for (Instance& instance : desc.instances) instance.movable = true;
  const RenderPlan moving = planned(desc);
  EXPECT_EQ(find(moving.built, "light volume", "image"), nullptr);
  EXPECT_EQ(find(moving.left_out, "light volume", "image")->note,
            "nothing in the scene stands: one voxel says so");
  desc.instances.clear();
  desc.ghosts.clear();
  const RenderPlan empty = planned(desc);
  for (const char* image : {"light volume", "surroundings", "ambient occlusion"})
    EXPECT_EQ(find(empty.left_out, image, "image")->note, "the scene has no instances") << image;
}

TEST(Plan, LeavesOutLightsThatNoModelBrings) {
  VisualDesc desc = test::make_scene();
  EXPECT_EQ(find(planned(desc).left_out, "lights of models", "buffer")->note,
            "no model brings one (KHR_lights_punctual)");
  desc.lights.resize(3);
  const RenderPlan lit = planned(desc);
  EXPECT_EQ(find(lit.built, "lights of models", "buffer")->bytes, 32U * 16U);
  desc.instances.clear();
  desc.ghosts.clear();
  EXPECT_EQ(find(planned(desc).left_out, "lights of models", "buffer")->note, "the scene has no instances");
}

TEST(Plan, NamesWhatIsWrongWithALight) {
  const auto of_light = [](const auto& spoil) {
    VisualDesc desc = test::make_scene();
    desc.lights.resize(2);
    desc.lights[1].name = "lamp";
    spoil(desc.lights[1]);
    return complaint(desc);
  };
  EXPECT_EQ(of_light([](PunctualLight& light) { light.carried_by = 2; }), "");
  EXPECT_NE(of_light([](PunctualLight& light) { light.carried_by = 0; }).find("light 1 (lamp) is carried by"),
            std::string::npos);
  EXPECT_NE(of_light([](PunctualLight& light) { light.carried_by = 9; }).find("instance 9, which is none"),
            std::string::npos);
  for (const float intensity : {-1.0F, 2e9F, std::nanf("")})
    EXPECT_NE(
        of_light([&](PunctualLight& light) { light.intensity = intensity; }).find("an intensity of 0 to"),
        std::string::npos);
  EXPECT_NE(of_light([](PunctualLight& light) { light.range = 0.0F; }).find("a range above 0 m"),
            std::string::npos);
  EXPECT_NE(of_light([](PunctualLight& light) { light.inner_cone_rad = 1.0F; }).find("outside the cone"),
            std::string::npos);
  const auto blind = [](PunctualLight& light) {
    light.kind = PunctualLight::Kind::spot;
    light.direction = glm::vec3(0.0F);
  };
  EXPECT_NE(of_light(blind).find("has no direction"), std::string::npos);
  VisualDesc many = test::make_scene();
  many.lights.resize(9);
  EXPECT_NE(complaint(many).find("9 lights beside its key light; use 8"), std::string::npos);
}

TEST(Plan, LeavesOutMarkersWithoutCheckpoints) {
  VisualDesc desc = test::make_scene();
  desc.markers.clear();
  const RenderPlan plan = planned(desc);
  EXPECT_FALSE(plan.markers);
  EXPECT_EQ(find(plan.built, "markers", "pipeline"), nullptr);
  EXPECT_EQ(find(plan.left_out, "markers", "pipeline")->note, "the scene has no checkpoints");
}

TEST(Plan, LeavesOutTheGhostWhereTheSceneHasNone) {
  VisualDesc desc = test::make_scene();
  desc.ghosts.clear();
  const RenderPlan plan = planned(desc);
  EXPECT_FALSE(plan.ghosts);
  for (const BuildItem& item : plan.built) EXPECT_FALSE(item.name.starts_with("ghost")) << item.name;
  for (const char* kind : {"buffer", "pipeline"})
    EXPECT_EQ(find(plan.left_out, "ghost", kind)->note, "the scene has no ghost");
}

TEST(Plan, RefusesAGhostOfNothingAndLinesOfNoWidth) {
  VisualDesc desc = test::make_scene();
  desc.ghosts[0].line_width = 0.0F;
  EXPECT_NE(complaint(desc).find("more than 0"), std::string::npos);
  desc = test::make_scene();
  desc.instances[2].movable = false;
  EXPECT_NE(complaint(desc).find("nothing movable"), std::string::npos);
}

TEST(Plan, LeavesOutShadowsForEachOfItsReasons) {
  const auto reason = [](const VisualDesc& desc, int size = 2048) {
    RenderOptions options;
    options.quality.shadow_size = size;
    const RenderPlan plan = planned(desc, options);
    EXPECT_EQ(plan.shadow_size, 0);
    EXPECT_EQ(find(plan.built, "shadow map", "image"), nullptr);
    return find(plan.left_out, "shadow map", "image")->note;
  };
  VisualDesc desc = test::make_scene();
  EXPECT_EQ(reason(desc, 0), "the quality setting switches shadows off");
  for (Instance& instance : desc.instances) instance.casts_shadow = false;
  EXPECT_EQ(reason(desc), "nothing in the scene throws a shadow");
  desc.key_light->casts_shadow = false;
  EXPECT_EQ(reason(desc), "the scene's key light throws no shadow");
  desc.key_light.reset();
  EXPECT_EQ(reason(desc), "the scene has no key light");
}

TEST(Plan, ScalesTheSceneAndNotThePicture) {
  RenderOptions options;
  options.extent = {640, 360};
  options.quality = {1, 1024, 0.5F};
  const RenderPlan plan = planned(test::make_scene(), options);
  EXPECT_EQ(plan.scene, (Extent{320, 180}));
  EXPECT_EQ(plan.picture, (Extent{640, 360}));
  EXPECT_EQ(find(plan.built, "scene samples", "image"), nullptr);
}

TEST(Plan, AnEmptySceneIsABackground) {
  const RenderPlan plan = planned(VisualDesc{});
  EXPECT_FALSE(plan.surfaces);
  EXPECT_EQ(find(plan.built, "vertices", "buffer"), nullptr);
}

TEST(Plan, NamesWhatIsWrong) {
  VisualDesc desc = test::make_scene();
  desc.instances[1].mesh = 9;
  EXPECT_NE(complaint(desc).find("instance 1 (box) shows mesh 9"), std::string::npos);

  desc = test::make_scene();
  desc.instances[2].X_WM[0][0] = -1.0F;
  EXPECT_NE(complaint(desc).find("mirrors or flattens"), std::string::npos);

  desc = test::make_scene();
  desc.meshes[2].normals.pop_back();
  EXPECT_NE(complaint(desc).find("mesh 2 (ball)"), std::string::npos);

  desc = test::make_scene();
  desc.meshes[1].indices[0] = 1000;
  EXPECT_NE(complaint(desc).find("index 1000"), std::string::npos);

  desc = test::make_scene();
  desc.markers[0].radius = 0.0F;
  EXPECT_NE(complaint(desc).find("marker 0 (above the box)"), std::string::npos);
}

TEST(Plan, RefusesOptionsOutOfRange) {
  RenderOptions options;
  options.quality.samples = 2;
  EXPECT_NE(complaint(test::make_scene(), options).find("use 1 or 4"), std::string::npos);
  options = {};
  options.quality.resolution_scale = 2.0F;
  EXPECT_NE(complaint(test::make_scene(), options).find("0.25 to 1"), std::string::npos);
  options = {};
  options.extent = {0, 720};
  EXPECT_NE(complaint(test::make_scene(), options).find("0 x 720"), std::string::npos);
}

}  // namespace
}  // namespace fulcrum::render
