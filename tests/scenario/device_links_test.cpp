#include "engine/scenario/device_links.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/scenario/device_shapes.h"
#include "engine/scenario/to_glm.h"
#include "haptics/math/rotation.h"
#include "tests/haptics/actuation/w6d.h"

namespace fulcrum::scenario::test {
namespace {

MechanismDesc w6d_table() {
  MechanismDesc desc = w6d::device(0.255, 0.145).mechanism;
  desc.q_DK = Quat(Eigen::AngleAxisd(-1.5707963267948966, Vec3::UnitY()));
  return desc;
}

const MappingDesc kMapping{
    .X_WD = {Quat(Eigen::AngleAxisd(0.4, Vec3(1, 2, -1).normalized())), Vec3(0.1, -0.2, 0.3)},
    .position_scale = 1,
    .force_scale = 1,
    .clutch_button = -1};

const Pose kHeld_DH[] = {{},
                         {quaternion_exp(Vec3(0.3, -0.2, 0.1)), Vec3(0.03, 0.04, -0.02)},
                         {quaternion_exp(Vec3(-0.4, 0.1, 0.3)), Vec3(-0.05, -0.03, 0.04)}};

// A link's own figures, carried by its pose, are at the joints where the mechanism has them.
TEST(DeviceLinks, LeadFromJointToJoint) {
  const MechanismDesc desc = w6d_table();
  DeviceLinks links(desc, kMapping);
  Mechanism mechanism(desc);
  for (const Pose& X_DH : kHeld_DH) {
    const std::vector<Pose>& X_WL = links.follow(kMapping.handle_in_world(X_DH));
    mechanism.follow(X_DH);
    ASSERT_LT(mechanism.out_of_reach(), 1e-6);
    ASSERT_EQ(X_WL.size(), 6u);
    for (std::size_t arm = 0; arm < 2; ++arm) {
      const std::vector<JointDesc>& joints = desc.arms[arm].joints;
      const JointChain::Placed placed = mechanism.placed(static_cast<int>(arm));
      for (std::size_t j = 0; j < joints.size(); ++j) {
        const Pose& X = X_WL[3 * arm + j];
        const bool last = j + 1 == joints.size();
        const Vec3 next_L =
            desc.q_DK * ((last ? desc.arms[arm].end_K : joints[j + 1].point_K) - joints[j].point_K);
        const Vec3 next_D = last ? placed.X_DE.p : placed.point_D[j + 1];
        EXPECT_LT((X.p - kMapping.X_WD * placed.point_D[j]).norm(), 1e-7);
        EXPECT_LT((X * next_L - kMapping.X_WD * next_D).norm(), 1e-7);
        EXPECT_LT((X.q * (desc.q_DK * joints[j].axis_K) - kMapping.X_WD.q * placed.axis_D[j]).norm(), 1e-7);
      }
    }
    EXPECT_LT((X_WL[2] * (desc.q_DK * (desc.arms[0].end_K - desc.arms[0].joints[2].point_K)) -
               kMapping.handle_in_world(X_DH).p)
                  .norm(),
              1e-6);
  }
}

// What is drawn of a link reaches both its joints: each is inside of the box around the link.
TEST(DeviceShapes, AreAroundTheJoints) {
  const MechanismDesc desc = w6d_table();
  render::VisualDesc visual;
  add_device_arms(visual, desc, kMapping, -0.5, 1);
  for (std::size_t body = 1; body <= 6; ++body) {
    const ArmDesc& arm = desc.arms[(body - 1) / 3];
    const std::size_t j = (body - 1) % 3;
    const Vec3 next = desc.q_DK * ((j == 2 ? arm.end_K : arm.joints[j + 1].point_K) - arm.joints[j].point_K);
    glm::vec3 low(1.0F), high(-1.0F);
    for (const render::Instance& instance : visual.instances) {
      if (instance.follows != body) continue;
      EXPECT_TRUE(instance.movable);
      for (const glm::vec3& p : visual.meshes[instance.mesh].positions) {
        low = glm::min(low, p);
        high = glm::max(high, p);
      }
    }
    for (const glm::vec3& joint : {glm::vec3(0.0F), narrowed(next)}) {
      EXPECT_TRUE(glm::all(glm::lessThanEqual(low - 1e-6F, joint)) &&
                  glm::all(glm::lessThanEqual(joint, high + 1e-6F)))
          << "link " << body;
    }
  }
}

// The foot is on the floor, however the device is turned.
TEST(DeviceShapes, StandOnTheFloor) {
  const auto lowest_of_base = [](std::optional<double> floor) {
    render::VisualDesc visual;
    add_device_arms(visual, w6d_table(), kMapping, floor, 1);
    float lowest = 1.0F;
    for (const render::Instance& instance : visual.instances) {
      if (instance.movable) continue;
      for (const glm::vec3& p : visual.meshes[instance.mesh].positions)
        lowest = std::min(lowest, (instance.X_WM * glm::vec4(p, 1.0F)).y);
    }
    return lowest;
  };
  EXPECT_NEAR(lowest_of_base(-0.5), -0.5F, 1e-4F);
  EXPECT_GT(lowest_of_base(std::nullopt), -0.4F);
}

}  // namespace
}  // namespace fulcrum::scenario::test
