// Models with lights of their own, as they are drawn: those of a tool go with it, every kind of surface has
// them, and what they look like together.

#include <cmath>

#include "image_compare.h"
#include "lit_scene.h"

namespace fulcrum::render {
namespace {

class LitModelsTest : public test::LitScene {
protected:
  static VisualDesc dim_scene() {
    VisualDesc desc = test::make_scene();
    desc.ghosts.clear();
    desc.key_light->intensity = 0.5F;
    desc.ambient.intensity = 0.2F;
    return desc;
  }

  static PunctualLight lamp() {
    PunctualLight light;
    light.position = {0.3F, 0.6F, 0.4F};
    light.intensity = 0.4F;
    return light;
  }

  Picture seen(const VisualDesc& desc, const Quality& quality) {
    return draw(*renderer(desc, {160, 90}, quality), desc.camera, desc.instances[2].X_WM);
  }

  static float brightness(const Picture& picture) {
    const glm::vec3 c = test::mean(picture, 0, 0, 1, 1);
    return c.r + c.g + c.b;
  }
};

// On its tip, looking along it: with the tool turned and moved it shines from elsewhere, also where its pose
// is told late.
TEST_F(LitModelsTest, AToolCarriesItsLight) {
  folder_.write("scenarios/peg/peg.glb",
                peg({R"({"type":"spot","intensity":40,"spot":{}})"},
                    {R"(,"translation":[0,-0.05,0],"rotation":[-0.70710678,0,0,0.70710678])"}));
  folder_.write(
      "scenarios/peg/lamps.glb",
      test::LitGlb{{{test::make_box(glm::vec3(0.01F)), {0, -0.2F, 0}, test::kMatt}}, {}, {}}.bytes());
  const VisualDesc desc = assembled("");
  ASSERT_EQ(desc.lights.size(), 1U);
  const auto close = close_up(desc);
  for (const float lean : {0.0F, 0.35F}) {
    const glm::mat4 X_WT =
        glm::rotate(glm::translate(glm::mat4(1.0F), {0.2F, 0.3F, -0.1F}), lean, {0.0F, 0.0F, 1.0F});
    // 70 mm below the centre of mass, as it leans.
    const glm::dvec3 along(std::sin(static_cast<double>(lean)), -std::cos(static_cast<double>(lean)), 0);
    const glm::dvec3 from = glm::dvec3(0.2, 0.3, -0.1) + 0.07 * along;
    const double outer = std::sqrt(0.5);
    for (const glm::dvec3& p_W :
         {glm::dvec3(0.28, 0, -0.1), glm::dvec3(0.2, 0, 0), glm::dvec3(0.32, 0, -0.15)}) {
      const double cosine = glm::dot(glm::normalize(p_W - from), along);
      const double part = std::clamp((cosine - outer) / (1 - outer), 0.0, 1.0);
      expect_lit(*close, p_W, part * part * test::from_point(40, from, p_W), X_WT);
    }
  }

  const auto from_afar = renderer(desc, {64, 48}, {1, 0, 1.0F});
  const auto drawn = [&](const glm::mat4& X_WT, const LatePoses& late) {
    return draw(*from_afar, {{0, 1, 0.1F}, {0, 0, 0}, 0.8F}, X_WT, late).rgba;
  };
  const glm::mat4 here = glm::translate(glm::mat4(1.0F), {0.1F, 0.3F, 0.0F});
  const glm::mat4 there = glm::translate(glm::mat4(1.0F), {-0.2F, 0.3F, 0.1F});
  const std::vector<std::uint8_t> wanted = drawn(there, {});
  EXPECT_TRUE(drawn(here, [&] { return std::span(&there, 1); }) == wanted);
  EXPECT_FALSE(drawn(here, {}) == wanted);
}

TEST_F(LitModelsTest, TheLeftHandsSceneIsLitAsItsMirrorImage) {
  const std::string node = R"(,"translation":[0.3,0.5,0],"rotation":[-0.5,0.5,0.5,0.5])";
  const std::string light =
      R"({"type":"spot","intensity":250,"spot":{"innerConeAngle":0.3,"outerConeAngle":0.7}})";
  const VisualDesc right = lit_by(light, node), left = assembled("", {"left_handed=true"});
  ASSERT_EQ(left.lights.size(), 1U);
  const glm::vec3 mirror(-1, 1, 1);
  EXPECT_EQ(left.lights[0].position, right.lights[0].position * mirror);
  EXPECT_EQ(left.lights[0].direction, right.lights[0].direction * mirror);
}

// In each way of drawing a surface: a light is seen, and what has a detail of nothing looks plain.
TEST_F(LitModelsTest, EveryWayOfDrawingHasThem) {
  struct Way {
    int shadow;
    bool soft, occlusion;
  };
  for (const auto& [shadow, soft, occlusion] : {Way{0, false, false},
                                                {0, false, true},
                                                {512, false, false},
                                                {512, false, true},
                                                {512, true, false},
                                                {512, true, true}}) {
    VisualDesc desc = dim_scene();
    desc.key_light->diameter = 0.05F;
    const Quality quality{1, shadow, 1.0F, 0.0F, occlusion, soft};
    const float without = brightness(seen(desc, quality));
    desc.lights = {lamp()};
    const Picture plain = seen(desc, quality);
    EXPECT_GT(brightness(plain), without + 10.0F);
    for (Material& material : desc.materials) material.detail = SurfaceDetail{};
    const test::Comparison same =
        test::compare(plain, seen(desc, quality),
                      {.max_lsb = 1, .max_pixels = 40, .max_share_by_one = 0.003, .failure_folder = {}});
    EXPECT_TRUE(same.passed) << same.sentence;
  }
}

// As the lights of a model do that is drawn cut open, or whole, alone.
TEST_F(LitModelsTest, ACameraOfOtherLayersDoesNotSeeThem) {
  VisualDesc desc = dim_scene();
  const float without = brightness(seen(desc, {1, 0, 1.0F}));
  desc.lights = {lamp()};
  desc.lights[0].layers = 2;
  EXPECT_NEAR(brightness(seen(desc, {1, 0, 1.0F})), without, 0.1F);
}

// A bench of matt, coated, woolly and metal balls under a low sun, a warm point and a spot from above.
TEST_F(LitModelsTest, LooksAsItsGolden) {
  const auto material = [](const std::string& colour, const std::string& metal_rough,
                           const std::string& more) {
    return R"({"pbrMetallicRoughness":{"baseColorFactor":[)" + colour + R"(,1],"metallicFactor":)" +
           metal_rough + "}" + more + "}";
  };
  const Mesh ball = test::make_ball(0.05F);
  const test::LitGlb bench{
      {{test::make_box({0.4F, 0.01F, 0.2F}),
        {0, 0.01F, 0},
        material("0.5,0.5,0.5", R"(0,"roughnessFactor":0.8)", "")},
       {test::make_box({0.4F, 0.15F, 0.01F}),
        {0, 0.17F, -0.2F},
        material("0.6,0.6,0.6", R"(0,"roughnessFactor":0.9)", "")},
       {ball, {-0.24F, 0.07F, 0}, material("0.7,0.7,0.7", R"(0,"roughnessFactor":1)", "")},
       {ball,
        {-0.08F, 0.07F, 0},
        material("0.4,0.02,0.02", R"(0,"roughnessFactor":0.8)",
                 R"(,"extensions":{"KHR_materials_clearcoat":{"clearcoatFactor":1}})")},
       {ball,
        {0.08F, 0.07F, 0},
        material(
            "0.05,0.05,0.2", R"(0,"roughnessFactor":1)",
            R"(,"extensions":{"KHR_materials_sheen":{"sheenColorFactor":[0.6,0.6,1],"sheenRoughnessFactor":0.5}})")},
       {ball, {0.24F, 0.07F, 0}, material("0.9,0.7,0.4", R"(1,"roughnessFactor":0.25)", "")}},
      {R"({"type":"directional","intensity":500,"color":[0.6,0.75,1]})",
       R"({"type":"point","intensity":60,"color":[1,0.6,0.3],"range":0.8})",
       R"({"type":"spot","intensity":400,"spot":{"innerConeAngle":0.15,"outerConeAngle":0.35}})"},
      {R"(,"rotation":[-0.2588,0.3830,0.1072,0.8804])", R"(,"translation":[-0.34,0.16,0.12])",
       R"(,"translation":[0.1,0.57,0.1],"rotation":[-0.6427876,0,0,0.7660444])"}};
  folder_.write("scenarios/peg/lamps.glb", bench.bytes());
  VisualDesc desc = assembled("");
  desc.ambient.intensity = 0.15F;
  const Picture picture = draw(*renderer(desc, {640, 360}, {4, 0, 1.0F}),
                               {{0.0F, 0.3F, 0.9F}, {0.0F, 0.07F, 0.0F}, 0.5F}, away());
  const test::Comparison result =
      test::compare(picture, std::filesystem::path(FULCRUM_GOLDENS) / "lights.png",
                    {.max_lsb = 2, .max_pixels = 20, .failure_folder = FULCRUM_FAILURES});
  EXPECT_TRUE(result.passed) << result.sentence;
}

}  // namespace
}  // namespace fulcrum::render
