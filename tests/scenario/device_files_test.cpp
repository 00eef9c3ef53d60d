// The device files that come with the program: that they load, and what their motors add up to.

#include <gtest/gtest.h>

#include "engine/scenario/content.h"
#include "engine/scenario/load.h"
#include "haptics/actuation/actuators.h"
#include "haptics/actuation/allocator.h"
#include "haptics/actuation/vibrotactile_actuator.h"
#include "tests/haptics/actuation/w6d.h"

namespace fulcrum::scenario {
namespace {

DeviceDesc shipped(const std::string& name) {
  const auto device =
      load_device(std::filesystem::path(FULCRUM_SOURCE_DIR) / "content" / "devices" / (name + ".yaml"));
  EXPECT_TRUE(device) << (device ? "" : to_text(device.faults()));
  return device ? *device : DeviceDesc();
}

// N or N m, the largest of this direction that an arm's motors give at home, the rest of the wrench zero.
double largest(DeviceDesc device, const Wrench& direction,
               AllocationMethod method = AllocationMethod::exact) {
  device.max_force = device.max_torque = 1e6;  // of the whole: not asked for here
  Allocator motors(device, {.method = method});
  const Wrench F = motors.allocate_uniform(direction * 1e3).F_H_D;
  return std::max(F.force.norm(), F.torque.norm());
}

TEST(DeviceFiles, AllLoadAndAreDevices) {
  const auto files = device_files({std::filesystem::path(FULCRUM_SOURCE_DIR) / "content"});
  EXPECT_GE(files.size(), 5u);
  for (const auto& [name, file] : files) {
    const DeviceDesc device = shipped(name);
    if (device.kinematics != Kinematics::arms) continue;
    const auto error = Mechanism::refuse(device.mechanism);
    EXPECT_FALSE(error) << name << ": " << (error ? error->sentence : "");
    EXPECT_EQ(device.renders_torque, Mechanism::motors(device.mechanism) >= 6) << name;
  }
}

// The table in the file is the paper's, in the device's axes: its x is towards the person, ours to the right.
TEST(DeviceFiles, TheW6DsMotorsAreThePapers) {
  const DeviceDesc device = shipped("w6d");
  const Mechanism of_file(device.mechanism), of_paper(w6d::device(0.511, 0.145).mechanism);
  const Quat q_DK = device.mechanism.q_DK;
  EXPECT_NEAR((q_DK * Vec3::UnitX() - Vec3::UnitZ()).norm(), 0, 1e-7);
  EXPECT_NEAR((q_DK * Vec3::UnitY() - Vec3::UnitY()).norm(), 0, 1e-7);
  for (int motor = 0; motor < 7; ++motor) {
    const Vec3 force = q_DK * Vec3(of_paper.wrenches().col(motor).head<3>());
    const Vec3 torque = q_DK * Vec3(of_paper.wrenches().col(motor).tail<3>());
    EXPECT_NEAR((of_file.wrenches().col(motor).head<3>() - force).norm(), 0, 1e-5) << motor;
    EXPECT_NEAR((of_file.wrenches().col(motor).tail<3>() - torque).norm(), 0, 1e-5) << motor;
  }
  const Vec3 x = Vec3::UnitZ(), y = Vec3::UnitY(), z = -Vec3::UnitX();  // the paper's
  EXPECT_NEAR(largest(device, {x, Vec3::Zero()}), 6.663, 6e-4);
  EXPECT_NEAR(largest(device, {y, Vec3::Zero()}), 3.969, 6e-4);
  EXPECT_NEAR(largest(device, {z, Vec3::Zero()}), 3.969, 6e-4);
  EXPECT_NEAR(largest(device, {x, Vec3::Zero()}, AllocationMethod::pseudoinverse), 5.211, 6e-4);
  EXPECT_NEAR(largest(device, {y, Vec3::Zero()}, AllocationMethod::pseudoinverse), 2.794, 6e-4);
  EXPECT_NEAR(largest(device, {z, Vec3::Zero()}, AllocationMethod::pseudoinverse), 2.595, 6e-4);
}

TEST(DeviceFiles, ASerialArmGivesWhatItsDataSheetSays) {
  const DeviceDesc device = shipped("serial6");
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(largest(device, {Vec3::Unit(axis), Vec3::Zero()}), 8.5, 0.03) << axis;
  EXPECT_NEAR(largest(device, {Vec3::Zero(), Vec3::UnitX()}), 0.188, 1e-9);
  EXPECT_NEAR(largest(device, {Vec3::Zero(), Vec3::UnitY()}), 0.188, 1e-9);
  EXPECT_NEAR(largest(device, {Vec3::Zero(), Vec3::UnitZ()}), 0.048, 1e-9);
}

TEST(DeviceFiles, TheFreedom6SIsThePapers) {
  const DeviceDesc device = shipped("freedom6s");
  EXPECT_EQ(device.handle_inertia, Vec3(5e-6, 1.7e-4, 1.7e-4));
  EXPECT_EQ(device.handle_mass, 0.25);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_NEAR(largest(device, {Vec3::Unit(axis), Vec3::Zero()}), 2.5, 1e-9) << axis;
  EXPECT_NEAR(largest(device, {Vec3::Zero(), Vec3::UnitX()}), 0.1, 1e-9);
  EXPECT_NEAR(largest(device, {Vec3::Zero(), Vec3::UnitY()}), 0.45, 1e-9);
  EXPECT_NEAR(largest(device, {Vec3::Zero(), Vec3::UnitZ()}), 0.45, 1e-9);
  // 0.4 N/mm at 100 mm is pitch alone; in series with 1 or 2 N/mm at the stage .286 to .333.
  ASSERT_TRUE(device.structure);
  StructureDesc structure = *device.structure;
  const auto at_100_mm = [&structure] { return stiffness_at(structure, {0.1, 0, 0}, Vec3::UnitY()); };
  for (const auto& [tip, expected] : {std::pair{1000.0, 285.714}, {2000.0, 333.333}, {1e12, 400.0}}) {
    structure.tip_stiffness = tip;
    EXPECT_NEAR(at_100_mm(), expected, 1e-3);
  }
  EXPECT_NEAR(stiffness_at(*device.structure, Vec3::Zero(), Vec3::UnitZ()), 1500, 1e-9);
  // Across the stick sideways it is yaw; along it nothing turns.
  EXPECT_NEAR(1 / stiffness_at(*device.structure, {0.1, 0, 0}, Vec3::UnitZ()), 1 / 1500.0 + 0.01 / 2.5, 1e-9);
  EXPECT_NEAR(stiffness_at(*device.structure, {0.1, 0, 0}, Vec3::UnitX()), 1500, 1e-9);
}

TEST(DeviceFiles, TheDesktopArmGivesItsForceAlongEveryAxis) {
  const DeviceDesc device = shipped("phantom_like");
  EXPECT_EQ(device.max_force, 7.9);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_GE(largest(device, {Vec3::Unit(axis), Vec3::Zero()}), device.max_force) << axis;
}

// Its interface recommends 5 N at most; 2 A give more along every axis in the middle of its workspace.
TEST(DeviceFiles, ThePolhemGivesItsForceAlongEveryAxis) {
  const DeviceDesc device = shipped("polhem");
  EXPECT_EQ(device.max_force, 5);
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_GE(largest(device, {Vec3::Unit(axis), Vec3::Zero()}), device.max_force) << axis;
  // 2 A, 0.0538 N m/A, capstans of 10 mm on drums of 180 and 100 mm.
  EXPECT_NEAR(Mechanism::motor_limit(device.mechanism, 0), 2 * 0.0538 * 18, 1e-3);
  for (const int link : {1, 2})
    EXPECT_NEAR(Mechanism::motor_limit(device.mechanism, link), 2 * 0.0538 * 10, 1e-3);
}

// Its data sheet says more than 8.9 N along one axis, and 400 dpi. What its motors of 0.4096 N m give in the
// middle, whatever the direction, is less: tests/drivers/falcon_arm_test.cpp has it from the geometry.
TEST(DeviceFiles, AFalconGivesItsForceAlongEveryAxisAndSensesNoTurn) {
  const DeviceDesc device = shipped("falcon");
  EXPECT_FALSE(device.senses_rotation);
  EXPECT_FALSE(device.renders_torque);
  EXPECT_EQ(Actuators::count(device), 3);
  EXPECT_LT(device.max_force, 8.9);
  EXPECT_LT(device.encoder_step, 0.0254 / 400);
  for (int axis = 0; axis < 3; ++axis) {
    EXPECT_EQ(Actuators(device).limits()[axis], 6) << axis;
    EXPECT_LE(2 * device.workspace[axis], 4 * 0.0254) << "the data sheet's";
  }
}

// Its maker's examples keep its handle within a ball of 0.1 m.
TEST(DeviceFiles, TheInverse3GivesItsForceAlongEveryAxis) {
  const DeviceDesc device = shipped("inverse3");
  EXPECT_EQ(device.max_force, 10);
  EXPECT_EQ(device.workspace, Vec3::Constant(0.1));
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_GE(largest(device, {Vec3::Unit(axis), Vec3::Zero()}), device.max_force) << axis;
}

// Two vibrators of 1.31 g at 233 Hz, as in "Virtual vibrotactile motion as lateral force", alone and on an
// arm.
TEST(DeviceFiles, TheFingertipsVibratorsDoWhatThePaperAsksFor) {
  for (const char* name : {"two_channel", "fingertip", "audio", "dualsense_coils"}) {
    const DeviceDesc device = shipped(name);
    ASSERT_TRUE(device.vibrotactile) << name;
    for (const char* side : {"left", "right"}) {
      const auto channel = device.vibrotactile->find(side);
      ASSERT_TRUE(channel) << name;
      EXPECT_GE(actuator_reach(device.vibrotactile->channels[*channel], 233), 1.31 * 9.8) << name;
    }
  }
  EXPECT_EQ(Actuators::count(shipped("two_channel")), 0);
  EXPECT_EQ(Actuators::count(shipped("rumble_pad")), 0);
  const DeviceDesc fingertip = shipped("fingertip");
  for (int axis = 0; axis < 3; ++axis)
    EXPECT_GE(largest(fingertip, {Vec3::Unit(axis), Vec3::Zero()}), fingertip.max_force) << axis;
  const DeviceDesc pad = shipped("rumble_pad");
  for (const ChannelDesc& channel : pad.vibrotactile->channels) EXPECT_EQ(channel.kind, ChannelKind::rumble);
}

// What is asked of them at any carrier, and the sides that their drivers know.
TEST(DeviceFiles, TheJoyConsAreToldTones) {
  for (const char* name : {"joycon", "switch_pro"}) {
    const DeviceDesc device = shipped(name);
    EXPECT_EQ(Actuators::count(device), 0) << name;
    ASSERT_TRUE(device.vibrotactile) << name;
    ASSERT_EQ(device.vibrotactile->channels.size(), 2U) << name;
    EXPECT_EQ(device.vibrotactile->find("left"), 0U) << name;
    for (const ChannelDesc& channel : device.vibrotactile->channels) {
      EXPECT_EQ(channel.kind, ChannelKind::tone) << name;
      EXPECT_EQ(actuator_reach(channel, 160), channel.largest) << name;
      EXPECT_EQ(actuator_reach(channel, 320), channel.largest) << name;
    }
  }
}

// It is the strip that its maker's data sheet describes, as that of the Freedom 6S is.
TEST(DeviceFiles, TheStripIsAStripAndPushesNothing) {
  const DeviceDesc device = shipped("strip");
  EXPECT_EQ(Actuators::count(device), 0);
  EXPECT_FALSE(device.vibrotactile);
  ASSERT_TRUE(device.strip);
  EXPECT_FALSE(refuse_strip(*device.strip));
  EXPECT_NEAR(place_of(*device.strip, 100), 0.03, 1e-12);
  EXPECT_NEAR(place_of(*device.strip, 10000), 0.17, 1e-12);
}

}  // namespace
}  // namespace fulcrum::scenario
