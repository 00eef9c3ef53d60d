// A picture of all around that a scenario names: where it comes to be in the world, and what is said of one
// that cannot be used.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "engine/scenario/surroundings_file.h"
#include "example.h"
#include "tests/assets/hdr_of.h"

namespace fulcrum::scenario {
namespace {

constexpr std::uint32_t kWidth = 64, kHeight = 32;

// Bright where a column and a row of the file are, dark elsewhere.
std::string spot_at(std::uint32_t column, std::uint32_t row) {
  const auto bytes = fulcrum::test::hdr_of(
      kWidth, kHeight, fulcrum::test::HdrRows::in_runs, [&](std::uint32_t x, std::uint32_t y) {
        return x == column && y == row ? fulcrum::test::Rgb{512, 256, 128} : fulcrum::test::Rgb{0, 0, 0};
      });
  return {bytes.begin(), bytes.end()};
}

class SurroundingsFile : public testing::Test {
protected:
  Scenario read(const std::string& ambient, const std::vector<std::string>& overrides = {}) const {
    const auto scenario = load_scenario_text(std::string(test::kScenario) + "ambient: " + ambient + "\n",
                                             folder_.peg(), overrides);
    if (!scenario) throw std::runtime_error(to_text(scenario.faults()));
    return *scenario;
  }

  // Where the light of a picture comes from, in its mean; what it has in all, where a pixel's brightest is
  // 512.
  static std::pair<glm::vec3, float> middle_of(const render::Panorama& picture) {
    glm::vec3 towards(0.0F);
    float power = 0.0F;
    for (std::size_t i = 0; i < picture.pixels.size(); ++i) {
      const float azimuth = 2.0F * std::numbers::pi_v<float> *
                            (static_cast<float>(i % picture.width) + 0.5F) /
                            static_cast<float>(picture.width);
      const float polar = std::numbers::pi_v<float> * (static_cast<float>(i / picture.width) + 0.5F) /
                          static_cast<float>(picture.height);
      towards += picture.pixels[i].r * glm::vec3(std::sin(polar) * std::sin(azimuth), std::cos(polar),
                                                 -std::sin(polar) * std::cos(azimuth));
      power += picture.pixels[i].r;
    }
    return {glm::normalize(towards), power};
  }

  void expect_light_from(const glm::vec3& wanted, const std::string& keys,
                         const std::vector<std::string>& overrides = {}) const {
    const Scenario scenario = read("{kind: picture, file: spot.hdr" + keys + "}", overrides);
    ASSERT_TRUE(scenario.surroundings);
    const auto picture = read_surroundings(scenario, *scenario.surroundings);
    ASSERT_TRUE(picture) << to_text(picture.faults());
    EXPECT_EQ(picture->width, kWidth);
    EXPECT_EQ(picture->height, kHeight);
    const auto [towards, power] = middle_of(*picture);
    EXPECT_GT(glm::dot(towards, glm::normalize(wanted)), 0.99F)
        << keys << ": " << towards.x << " " << towards.y << " " << towards.z;
    EXPECT_NEAR(power, 512.0F, 0.1F);
  }

  test::Folder folder_;
};

// Blender's and three.js's convention: the middle of the picture is towards +x, and what is right of it
// towards +z.
TEST_F(SurroundingsFile, ItsMiddleIsTowardsXAndItsRightTowardsZ) {
  folder_.write("scenarios/peg/spot.hdr", spot_at(32, 16));
  expect_light_from({1, 0, 0}, "");
  folder_.write("scenarios/peg/spot.hdr", spot_at(48, 16));
  expect_light_from({0, 0, 1}, "");
  folder_.write("scenarios/peg/spot.hdr", spot_at(0, 16));
  expect_light_from({-1, 0, 0}, "");
  folder_.write("scenarios/peg/spot.hdr", spot_at(16, 16));
  expect_light_from({0, 0, -1}, "");
  folder_.write("scenarios/peg/spot.hdr", spot_at(20, 0));
  expect_light_from({0, 1, 0}, "");
}

// Against the clock from above: from +x towards -z. A turn that is no whole number of columns shares the
// light.
TEST_F(SurroundingsFile, TurnsAboutTheVertical) {
  folder_.write("scenarios/peg/spot.hdr", spot_at(32, 16));
  expect_light_from({0, 0, -1}, ", turn_deg: 90");
  expect_light_from({0, 0, 1}, ", turn_deg: -90");
  expect_light_from({-1, 0, 0}, ", turn_deg: 180");
  const float turn = std::numbers::pi_v<float> / 6;
  expect_light_from({std::cos(turn), 0, -std::sin(turn)}, ", turn_deg: 30");
  expect_light_from({std::cos(turn), 0, std::sin(turn)}, ", turn_deg: -30");
}

TEST_F(SurroundingsFile, IsMirroredForALeftHand) {
  folder_.write("scenarios/peg/spot.hdr", spot_at(32, 16));
  expect_light_from({-1, 0, 0}, "", {"left_handed=true"});
  const float turn = std::numbers::pi_v<float> / 6;
  expect_light_from({-std::cos(turn), 0, -std::sin(turn)}, ", turn_deg: 30", {"left_handed=true"});
}

TEST_F(SurroundingsFile, AScenarioWithoutOneHasTheStudio) {
  EXPECT_FALSE(read("{sky: [1, 1, 1]}").surroundings);
  EXPECT_FALSE(read("{kind: studio, intensity: 2}").surroundings);
  EXPECT_EQ(read("{kind: studio, intensity: 2}").ambient.intensity, 2.0F);
  folder_.write("scenarios/peg/spot.hdr", spot_at(32, 16));
  const Scenario scenario = read("{kind: picture, file: spot.hdr, intensity: 3, seen: true}");
  EXPECT_EQ(scenario.ambient.intensity, 3.0F);
  EXPECT_TRUE(scenario.surroundings->seen);
}

TEST_F(SurroundingsFile, IsRefusedWhereItIsNamed) {
  folder_.write("scenarios/peg/spot.hdr", spot_at(32, 16).substr(0, 200));
  folder_.write("scenarios/peg/huge.hdr", "#?RADIANCE\n\n-Y 5000 +X 10000\n");
  const auto said_of = [&](const std::string& file) {
    const Scenario scenario = read("{kind: picture, file: " + file + "}");
    const auto picture = read_surroundings(scenario, *scenario.surroundings);
    return picture ? std::string("nothing") : to_text(picture.faults());
  };
  const std::string damaged = said_of("spot.hdr");
  EXPECT_EQ(damaged.rfind("scenario.yaml:20:32: ", 0), 0u) << damaged;
  EXPECT_NE(damaged.find("'spot.hdr' cannot be used: it is damaged (it ends too early); export it again"),
            std::string::npos)
      << damaged;
  EXPECT_NE(said_of("sopt.hdr").find("did you mean 'spot.hdr'?"), std::string::npos) << said_of("sopt.hdr");
  EXPECT_NE(said_of("huge.hdr").find("make it smaller, at most 4096 x 2048"), std::string::npos);
  EXPECT_NE(said_of("sure.yaml").find("no Radiance picture"), std::string::npos);
  const std::string text = test::kScenario;
  EXPECT_NE(test::faults_of(folder_, text + "ambient: {kind: picture}\n").find("'ambient.file' is missing"),
            std::string::npos);
  EXPECT_NE(test::faults_of(folder_, text + "ambient: {kind: picture, file: ../other.hdr}\n")
                .find("leads out of it"),
            std::string::npos);
  EXPECT_NE(test::faults_of(folder_, text + "ambient: {kind: picture, file: spot.hdr, sky: [1, 1, 1]}\n")
                .find("sky"),
            std::string::npos);
}

TEST_F(SurroundingsFile, IsNeeded) {
  try {
    read("picture");
    ADD_FAILURE() << "a picture without a file is taken";
  } catch (const std::runtime_error& refusal) {
    EXPECT_NE(std::string(refusal.what()).find("'ambient.file' is missing"), std::string::npos)
        << refusal.what();
  }
}

}  // namespace
}  // namespace fulcrum::scenario
