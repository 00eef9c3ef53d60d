// A scenario for the left hand: every place and pose of it against M p and M X M, written out here as
// matrices, and what must not be mirrored.

#include "engine/scenario/mirror.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <string>
#include <vector>

#include "engine/scenario/content.h"
#include "engine/scenario/load.h"
#include "engine/scenario/to_glm.h"
#include "tests/scenario/example.h"

namespace fulcrum::scenario::test {
namespace {

const Mat3 M = Vec3(-1, 1, 1).asDiagonal();

const std::filesystem::path kContent = std::filesystem::path(FULCRUM_SOURCE_DIR) / "content";

Checked<Scenario> load_shipped(const std::string& name, const std::vector<std::string>& overrides) {
  return load_scenario(kContent / "scenarios" / name / kScenarioFile, overrides);
}

void expect_mirrored(const Pose& mirrored, const Pose& X, const std::string& what) {
  const Mat3 R = mirrored.q.toRotationMatrix() - M * X.q.toRotationMatrix() * M;
  EXPECT_LT(R.norm(), 1e-14) << what;
  EXPECT_EQ(mirrored.p, M * X.p) << what;
}

void expect_mirrored(const glm::vec3& mirrored, const glm::vec3& p, const std::string& what) {
  EXPECT_EQ(mirrored, glm::vec3(-p.x, p.y, p.z)) << what;
}

TEST(Mirrored, EveryPlaceOfAShippedScenarioIs) {
  const Installed installed(kContent);
  for (const char* const name : {"piping", "teeth", "ear", "knock", "sweep", "nut", "tutorial"}) {
    const auto right = load_shipped(name, {}), left = load_shipped(name, {"left_handed=true"});
    ASSERT_TRUE(right) << to_text(right.faults());
    ASSERT_TRUE(left) << to_text(left.faults());
    expect_mirrored(left->tool.X_HM, right->tool.X_HM, name);
    expect_mirrored(left->tool.X_WM_start, right->tool.X_WM_start, name);
    EXPECT_EQ(left->tool.touch_point, M * right->tool.touch_point);
    EXPECT_NE(right->tool.touch_name, "");
    EXPECT_EQ(left->tool.touch_name, right->tool.touch_name);
    expect_mirrored(left->device.mapping.X_WD, right->device.mapping.X_WD, name);
    for (std::size_t i = 0; i < right->checkpoints.size(); ++i)
      EXPECT_EQ(left->checkpoints[i].position, M * right->checkpoints[i].position);
    ASSERT_FALSE(right->hands.empty());
    for (std::size_t hand = 0; hand < right->hands.size(); ++hand)
      for (std::size_t i = 0; i < right->hands[hand].waypoints.size(); ++i)
        expect_mirrored(left->hands[hand].waypoints[i].X_WT, right->hands[hand].waypoints[i].X_WT, name);
    for (std::size_t i = 0; i < right->views.size(); ++i) {
      expect_mirrored(left->views[i].camera.eye, right->views[i].camera.eye, name);
      expect_mirrored(left->views[i].camera.target, right->views[i].camera.target, name);
    }
    if (right->light) {
      expect_mirrored(left->light->direction, right->light->direction, name);
      expect_mirrored(left->light->position, right->light->position, name);
    }
    if (right->guide) {
      EXPECT_EQ(left->guide->from_W, M * right->guide->from_W);
      EXPECT_EQ(left->guide->to_W, M * right->guide->to_W);
    }
    if (right->effects.braking_pulse)
      EXPECT_EQ(left->effects.braking_pulse->p_HG, M * right->effects.braking_pulse->p_HG);
    EXPECT_EQ(left->device.desc.workspace, right->device.desc.workspace);
    EXPECT_EQ(left->device.desc.mechanism.arms.size(), right->device.desc.mechanism.arms.size());
  }
}

// Texts of both are compared, and numbers bit for bit by what a tape would keep.
TEST(Mirrored, TwiceItIsWhatItWas) {
  const Installed installed(kContent);
  for (const char* const name : {"piping", "teeth", "ear", "knock", "sweep", "nut", "tutorial"}) {
    const auto right = load_shipped(name, {});
    auto left = load_shipped(name, {"left_handed=true"});
    ASSERT_TRUE(right && left);
    mirror(*left);
    EXPECT_EQ(left->tool.X_HM.q.coeffs(), right->tool.X_HM.q.coeffs());
    EXPECT_EQ(left->tool.X_WM_start.p, right->tool.X_WM_start.p);
    EXPECT_EQ(left->device.mapping.X_WD.p, right->device.mapping.X_WD.p);
    for (std::size_t i = 0; i < right->checkpoints.size(); ++i) {
      EXPECT_EQ(left->checkpoints[i].name, right->checkpoints[i].name);
      EXPECT_EQ(left->checkpoints[i].mirrored_name, right->checkpoints[i].mirrored_name);
      EXPECT_EQ(left->checkpoints[i].position, right->checkpoints[i].position);
    }
    for (std::size_t i = 0; i < right->hands[0].waypoints.size(); ++i)
      EXPECT_EQ(left->hands[0].waypoints[i].X_WT.q.coeffs(), right->hands[0].waypoints[i].X_WT.q.coeffs());
  }
}

TEST(Mirrored, CheckpointsAreCalledAsTheyAreSeen) {
  const Installed installed(kContent);
  const auto sweep = load_shipped("sweep", {"left_handed=true"});
  const auto teeth = load_shipped("teeth", {"left_handed=true"});
  ASSERT_TRUE(sweep && teeth);
  for (const Checkpoint& checkpoint : sweep->checkpoints) {
    if (checkpoint.name.starts_with("right")) EXPECT_GT(checkpoint.position.x(), 0) << checkpoint.name;
    if (checkpoint.name.starts_with("left")) EXPECT_LT(checkpoint.position.x(), 0) << checkpoint.name;
  }
  EXPECT_EQ(teeth->checkpoints[0].name, "fissure of 36");
  EXPECT_GT(teeth->checkpoints[0].position.x(), 0);
}

// No shipped scenario turns its device's base, has a texture or a window that begins beside the middle.
TEST(Mirrored, SoAreABaseThatIsTurnedATextureAndAWindow) {
  const Installed installed(kContent);
  const std::vector<std::string> set{"device.base.orientation=[0.8, 0.36, 0.48, 0]",
                                     "texture.direction=[0.6, 0.1, 0.7]",
                                     "vibrotactile_motion.centre=[0.01, 0.02, 0.03]"};
  std::vector<std::string> mirrored = set;
  mirrored.emplace_back("left_handed=true");
  const auto right = load_shipped("sweep", set), left = load_shipped("sweep", mirrored);
  ASSERT_TRUE(right) << to_text(right.faults());
  ASSERT_TRUE(left) << to_text(left.faults());
  expect_mirrored(left->device.mapping.X_WD, right->device.mapping.X_WD, "base");
  EXPECT_EQ(left->effects.texture->direction_W, M * right->effects.texture->direction_W);
  EXPECT_EQ(left->effects.vibrotactile_motion->centre_W, M * right->effects.vibrotactile_motion->centre_W);
}

// Its way is known once the scenario is assembled; of what is given it has no sides.
TEST(Mirrored, SoIsTheWayOfGuidance) {
  EffectDescs effects;
  effects.guidance.emplace().way = {{0, {Quat(0.8, 0.36, 0.48, 0), Vec3(0.1, 0.2, 0.3)}, true}};
  EffectDescs mirrored = effects;
  fulcrum::mirror(mirrored);
  expect_mirrored(mirrored.guidance->way[0].X_WT, effects.guidance->way[0].X_WT, "way");
}

TEST(Mirrored, AVibratorToTheRightStaysThere) {
  const Installed installed(kContent);
  const auto left = load_shipped("sweep", {"left_handed=true", "vibrotactile_motion.axis=[0.9, 0.2, -0.1]"});
  ASSERT_TRUE(left) << to_text(left.faults());
  EXPECT_EQ(left->effects.vibrotactile_motion->axis_W, Vec3(0.9, -0.2, 0.1));
}

// A stick's places and those at which two arms hold a stylus are the device's own.
TEST(Mirrored, WhatIsTheDevicesOwnIsRefusedWithTheReason) {
  const Installed installed(kContent);
  for (const auto& [name, why] :
       {std::pair("stick", "the places of 'holding_point'"),
        std::pair("plate", "the arms of the device 'Entact W6D' hold the tool at two")}) {
    const auto refused = load_shipped(name, {"left_handed=true"});
    ASSERT_FALSE(refused) << name;
    EXPECT_NE(to_text(refused.faults()).find(why), std::string::npos) << to_text(refused.faults());
    EXPECT_NE(to_text(refused.faults()).find("leave it out"), std::string::npos) << to_text(refused.faults());
    EXPECT_TRUE(load_shipped(name, {"left_handed=false"})) << name;
  }
  EXPECT_FALSE(load_shipped("teeth", {"left_handed=true", "device.model=w6d"}));
  EXPECT_TRUE(load_shipped("plate", {"left_handed=true", "device.model=polhem", "device.drawn=false"}));
}

// The boxes of the studio that metal mirrors stand at the other side, too.
TEST(Mirrored, TheStudioIs) {
  const Installed installed(kContent);
  const auto right = load_shipped("sweep", {}), left = load_shipped("sweep", {"left_handed=true"});
  ASSERT_TRUE(right && left);
  EXPECT_FALSE(right->ambient.mirrored);
  EXPECT_TRUE(left->ambient.mirrored);
}

TEST(Mirrored, NamesMustDifferThereToo) {
  const Folder folder;
  const std::string two = replaced(kScenario, "  - {name: hole, position: [0, 0, 0], radius: 0.005}\n",
                                   "  - {name: left, mirrored_name: right, position: [0, 0, 0]}\n"
                                   "  - {name: right, position: [0, 0, 0]}\n");
  EXPECT_NE(faults_of(folder, two).find("where the scene is mirrored"), std::string::npos)
      << faults_of(folder, two);
}

// A corner of a block: its volume by the divergence theorem is positive only while its triangles are seen
// counter-clockwise from outside.
TEST(Mirrored, AModelStaysWoundOutwards) {
  Model model;
  ModelPart& part = model.parts.emplace_back();
  part.positions = {{0, 0, 0}, {1, 0, 0}, {0, 2, 0}, {0, 0, 3}};
  part.normals.assign(4, Vec3(-0.6, 0, 0.8));
  part.indices = {0, 2, 1, 0, 3, 2, 0, 1, 3, 1, 2, 3};
  const auto volume = [&] {
    double six = 0;
    for (std::size_t i = 0; i < part.indices.size(); i += 3)
      six += part.positions[part.indices[i]].dot(
          part.positions[part.indices[i + 1]].cross(part.positions[part.indices[i + 2]]));
    return six / 6;
  };
  ASSERT_NEAR(volume(), 1, 1e-15);
  mirror(model);
  EXPECT_NEAR(volume(), 1, 1e-15);
  EXPECT_EQ(part.positions[1], Vec3(-1, 0, 0));
  EXPECT_EQ(part.normals[0], Vec3(0.6, 0, 0.8));
}

}  // namespace
}  // namespace fulcrum::scenario::test
