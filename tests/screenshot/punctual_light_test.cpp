// Lights that models bring (KHR_lights_punctual), from the numbers in a file to those of pixels: a matt floor
// under each kind is as bright as photometry says, E = I cos / d^2, wherever a file's nodes and a scenario
// put the light. 683 lm are a watt, and radiance 1 is 1 W / (sr m^2).

#include <cmath>

#include "lit_scene.h"

namespace fulcrum::render {
namespace {

constexpr double kPi = std::numbers::pi;

class PunctualLightTest : public test::LitScene {};

TEST_F(PunctualLightTest, APointFallsOffWithTheSquareOfItsDistance) {
  for (const double height : {0.2, 0.5, 1.0}) {
    const std::string above = R"(,"translation":[0.1,)" + std::to_string(height) + ",0]";
    const double intensity = 900 * height * height;
    const VisualDesc desc =
        lit_by(R"({"type":"point","intensity":)" + std::to_string(intensity) + "}", above);
    const auto close = close_up(desc);
    for (const glm::vec3& p_W : {glm::vec3(0.1F, 0, 0), glm::vec3(0.4F, 0, 0), glm::vec3(-0.3F, 0, 0.6F)})
      expect_lit(*close, p_W, test::from_point(intensity, {0.1, height, 0}, p_W));
  }
}

// As the lamp of a scope is, in an ear. So little of the floor is looked at that its light is even there.
TEST_F(PunctualLightTest, ALampMayBeNearerThanAMillimetre) {
  for (const double height : {0.0004, 0.002, 0.008}) {
    const double intensity = 900 * height * height;
    const VisualDesc desc = lit_by(R"({"type":"point","intensity":)" + std::to_string(intensity) + "}",
                                   R"(,"translation":[0,)" + std::to_string(height) + ",0]");
    const auto close = close_up(desc);
    for (const double aside : {0.0, 0.7, 1.5}) {
      const glm::vec3 p_W(static_cast<float>(aside * height), 0, 0);
      expect_lit(*close, p_W, test::from_point(intensity, {0, height, 0}, p_W), away(),
                 static_cast<float>(0.1 * height));
    }
  }
}

TEST_F(PunctualLightTest, ARangeWindowsIt) {
  const VisualDesc desc =
      lit_by(R"({"type":"point","intensity":300,"range":0.8})", R"(,"translation":[0,0.4,0])");
  const auto close = close_up(desc);
  for (const float x : {0.0F, 0.3F, 0.5F, 0.6F, 0.68F, 0.75F}) {
    const double d = std::hypot(0.4, static_cast<double>(x)), part = std::pow(d / 0.8, 4);
    expect_lit(*close, {x, 0, 0}, std::max(1 - part, 0.0) * test::from_point(300, {0, 0.4, 0}, {x, 0, 0}));
  }
}

// Turned about x, so that what looked along -z looks down as well.
TEST_F(PunctualLightTest, ADirectionalOneIsInLux) {
  for (const double turn : {30.0, 60.0, 90.0}) {
    const double half = turn * kPi / 360;
    const std::string node = R"(,"translation":[0,5,0],"scale":[3,3,3],"rotation":[)" +
                             std::to_string(-std::sin(half)) + ",0,0," + std::to_string(std::cos(half)) + "]";
    const VisualDesc desc = lit_by(R"({"type":"directional","intensity":1500,"range":1})", node);
    const auto close = close_up(desc);
    for (const glm::vec3& p_W : {glm::vec3(0.0F), glm::vec3(0.9F, 0, -0.8F)})
      expect_lit(*close, p_W, 1500 * std::sin(2 * half));
  }
}

TEST_F(PunctualLightTest, ASpotFadesBetweenItsCones) {
  const std::string down = R"(,"translation":[0,0.5,0],"rotation":[-0.70710678,0,0,0.70710678])";
  const VisualDesc desc =
      lit_by(R"({"type":"spot","intensity":250,"spot":{"innerConeAngle":0.3,"outerConeAngle":0.7}})", down);
  const auto close = close_up(desc);
  for (const double angle : {0.0, 0.15, 0.28, 0.4, 0.5, 0.6, 0.72, 0.9}) {
    const double inner = std::cos(0.3), outer = std::cos(0.7);
    const double part = std::clamp((std::cos(angle) - outer) / (inner - outer), 0.0, 1.0);
    const glm::dvec3 p_W(0.5 * std::tan(angle) * 0.6, 0, 0.5 * std::tan(angle) * 0.8);
    expect_lit(*close, p_W, part * part * test::from_point(250, {0, 0.5, 0}, p_W));
  }
}

// Drawn in millimetres, at half its size, turned and moved by the scenario: as bright as in the author's
// program, where all is 2000 times as large.
TEST_F(PunctualLightTest, AModelsScaleKeepsWhatItsLightsGiveToIt) {
  const std::string light = R"({"type":"spot","intensity":1e9,"range":1600,)"
                            R"("spot":{"innerConeAngle":0.2,"outerConeAngle":0.9}})";
  // 800 mm along the file's x, looking back along it; the scenario turns x up.
  const VisualDesc desc =
      lit_by(light, R"(,"translation":[800,0,0],"rotation":[0,0.70710678,0,0.70710678])",
             ", unit: mm, scale: 0.5, position: [0.1, 0.05, 0], orientation: [0.70710678, 0, 0, 0.70710678]");
  ASSERT_EQ(desc.lights.size(), 1U);
  EXPECT_NEAR(glm::distance(desc.lights[0].position, glm::vec3(0.1F, 0.45F, 0)), 0, 1e-5F);
  EXPECT_NEAR(*desc.lights[0].range, 0.8F, 1e-5F);
  const double outer = std::cos(0.9), steep = 1 / (std::cos(0.2) - outer);
  const auto close = close_up(desc);
  for (const float x : {0.1F, 0.25F, 0.45F}) {
    const glm::dvec3 p_W(x, 0, 0), from(0.1, 0.45, 0);
    const double d = glm::length(from - p_W), part = std::clamp((0.45 / d - outer) * steep, 0.0, 1.0);
    // In the file's own millimetres: 1e9 cd at 2000 d.
    const double E = 1e9 / (2000 * d * 2000 * d) * 0.45 / d;
    expect_lit(*close, p_W, part * part * (1 - std::pow(d / 0.8, 4)) * E);
  }
}

}  // namespace
}  // namespace fulcrum::render
