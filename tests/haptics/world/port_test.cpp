// energy/port against the work at the device, added up from what the handle was told and where it went.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "haptics/math/rotation.h"
#include "haptics/safety/faults.h"
#include "tests/haptics/scenes.h"

namespace fulcrum::test {
namespace {

struct Scales {
  double position, force;
};

// A bar over a floor, on a device with six motors.
SceneDesc bar_scene(const Scales& scales, double encoder_step, double encoder_step_rad) {
  SceneDesc desc =
      floor_scene({{0.04, -0.005, 0}, {0.02, -0.005, 0.01}, {-0.02, -0.005, 0.01}, {-0.04, -0.005, 0}}, 0.01);
  desc.device.renders_torque = true;
  desc.device.max_force = 1e3;
  desc.device.max_torque = 1e2;
  desc.device.handle_weight = 0;
  desc.device.encoder_step = encoder_step;
  desc.device.encoder_step_rad = encoder_step_rad;
  desc.mapping.position_scale = scales.position;
  desc.mapping.force_scale = scales.force;
  desc.mapping.X_WD = {quaternion_exp(Vec3(0.3, 0.7, -0.2)), Vec3(0.02, 0.01, 0.03)};
  desc.contact.stiffness = 2000;
  desc.coupling = {
      .stiffness = 500, .angular_stiffness = 1, .damping_ratio = 0.3, .max_force = 1e3, .max_torque = 1e2};
  return desc;
}

// Where a hand that presses, rolls and winds has the handle, in W.
Pose at_work(double t) {
  return {quaternion_exp(Vec3(0.05 * std::sin(7 * t), 0.2 * std::sin(11 * t), 0.15 * std::sin(5 * t + 1))),
          Vec3(0.01 * std::sin(3 * t), 0.004 + 0.01 * std::cos(9 * t), 0.005 * std::sin(13 * t))};
}

struct Account {
  double port = 0, truth = 0, above = 0, torque_work = 0;  // J
  double first_force = 0;                                  // N, all axes together, when it was opened
};

// From when the force is whole.
Account keep_books(const SceneDesc& desc) {
  World world = expect(World::build(desc));
  Account account;
  double opened = 0;
  Wrench told;
  Pose before;
  for (int k = 0; k < 6000; ++k) {
    const Pose X_DH = desc.mapping.handle_in_device(at_work(desc.tick_s * k));
    Pose seen = X_DH;
    if (desc.device.encoder_step > 0)
      seen.p = (seen.p / desc.device.encoder_step).array().round() * desc.device.encoder_step;
    const StepResult result = step(world, at(seen), {});
    const TickRecord& record = result.record;
    if (record.force_gain < 1) {
      opened = record.energy_port;
    } else {
      if (told.is_zero()) {
        opened = record.energy_port;
        account.first_force = result.command.F_H_D.force.cwiseAbs().sum();
      }
      const double by_torque = -told.torque.dot(rotation_vector(X_DH.q * before.q.conjugate()));
      if (!told.is_zero()) account.truth += -told.force.dot(X_DH.p - before.p) + by_torque;
      account.torque_work += std::abs(by_torque);
      told = result.command.F_H_D;
      account.port = record.energy_port - opened;
      account.above = std::max(account.above, account.port - account.truth);
    }
    before = X_DH;
  }
  return account;
}

TEST(Port, IsTheWorkAtTheDeviceInItsOwnMeasure) {
  for (const Scales& scales : {Scales{1, 1}, Scales{2.5, 0.4}, Scales{0.8, 1}, Scales{5, 2}}) {
    const Account account = keep_books(bar_scene(scales, 0, 0));
    EXPECT_GT(account.torque_work, 0.01);
    EXPECT_NEAR(account.port, account.truth, 1e-9) << scales.position << ", " << scales.force;
  }
}

// A torque is a force on a lever, and levers are as much shorter at the device as ways are: who turns the
// handle by its end feels the end pushed back as the scene pushes.
TEST(Port, TorqueIsScaledAsAForceOnItsLever) {
  MappingDesc mapping;
  mapping.position_scale = 2.5;
  mapping.force_scale = 0.4;
  const Vec3 lever_W(0.1, 0.02, -0.03), force_W(1, -2, 0.5);
  const Wrench F_H_D = mapping.wrench_in_device({force_W, lever_W.cross(force_W)});
  EXPECT_NEAR((F_H_D.torque - Vec3(lever_W / 2.5).cross(F_H_D.force)).norm(), 0, 1e-15);
  const Wrench back = mapping.wrench_in_world(F_H_D);
  EXPECT_NEAR((back.torque - lever_W.cross(force_W)).norm(), 0, 1e-15);
}

TEST(Port, ReadsNoBetterThanTheWorkAtTheDeviceWhateverTheEncoders) {
  for (const double step : {5e-6, 28e-6, 100e-6}) {
    const Account account = keep_books(bar_scene({2.5, 0.4}, step, 0));
    // What it opened with is less by a step's worth: the handle was anywhere within one.
    EXPECT_LT(account.above, step * account.first_force + 1e-9) << step;
  }
}

}  // namespace
}  // namespace fulcrum::test
