// An effect from outside haptics/effects passes no limit. Truth: the energy of the port is summed up here,
// from what the device was told and where its handle went.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <vector>

#include "haptics/safety/faults.h"
#include "tests/haptics/scenes.h"

namespace fulcrum::test {
namespace {

SceneDesc free_scene() {
  SceneDesc desc = floor_scene({Vec3::Zero()}, 0.05);
  desc.contact.response = ContactResponse::constraint;
  desc.device.handle_weight = 0;
  desc.device.encoder_step = desc.device.encoder_step_rad = 0;
  return desc;
}

class Own : public Effect {
public:
  void record(EffectRecords&) const noexcept override {}
  BuiltPart part() const override { return {"own", "tries what it may not", sizeof *this}; }
};

// Pushes along x, and says that all of it only makes up for the device.
class Unaccounted final : public Own {
public:
  Wrench correct(const EffectTick&) noexcept override { return push_; }
  Settled settle(const EffectTick&, const Rendered&) noexcept override { return {.correction_F_H_D = push_}; }

private:
  Wrench push_{Vec3(1, 0, 0), Vec3::Zero()};
};

class NotANumber final : public Own {
public:
  Wrench shape(const EffectTick& tick) noexcept override {
    return {Vec3::Constant(tick.tick < 1000 ? 0 : std::numeric_limits<double>::quiet_NaN()), Vec3::Zero()};
  }
};

World world_with(std::unique_ptr<Effect> effect) {
  std::vector<std::unique_ptr<Effect>> own;
  own.push_back(std::move(effect));
  return expect(World::build(free_scene(), std::move(own)));
}

TEST(OwnEffect, CannotHideEnergyFromTheObserver) {
  World world = world_with(std::make_unique<Unaccounted>());
  const auto at_x = [&](double x) {
    return at(world.desc().mapping.handle_in_device({Quat::Identity(), Vec3(x, 0.05, 0)}));
  };
  for (int i = 0; i < 1000; ++i) step(world, at_x(0), {});
  StepResult before = step(world, at_x(0), {});
  ASSERT_GT(before.record.device_F_H_D.force.norm(), 0.9);
  const double start = before.record.energy_port;
  double given = 0;  // J, by the hand
  bool resisted = false;
  for (int i = 1; i <= 200; ++i) {  // the force drives the hand on, by 20 mm
    const Vec3 F = before.record.device_F_H_D.force, p = before.record.X_WH.p;
    before = step(world, at_x(1e-4 * i), {});
    given -= F.dot(before.record.X_WH.p - p);  // D and W are parallel and of one scale here
    resisted = resisted || (before.record.faults & kPassivityControl) != 0;
  }
  EXPECT_LT(given, -1e-4);
  EXPECT_NEAR(before.record.energy_port - start, given, 0.05 * std::abs(given));
  EXPECT_TRUE(resisted);
}

TEST(OwnEffect, ThatGivesNoNumberStopsTheForce) {
  World world = world_with(std::make_unique<NotANumber>());
  const Pose X_DH = world.desc().mapping.handle_in_device({Quat::Identity(), Vec3(0.01, 0.05, 0)});
  std::uint32_t faults = 0;
  for (int i = 0; i < 1100; ++i) {
    const StepResult result = step(world, at(X_DH), {});
    ASSERT_TRUE(result.command.F_H_D.is_finite()) << i;
    ASSERT_LE(result.command.F_H_D.force.norm(), world.desc().device.max_force) << i;
    faults |= result.record.faults;
    if (i > 1003) {
      EXPECT_TRUE(result.record.stopped) << i;
      EXPECT_EQ(result.command.F_H_D.force.norm(), 0) << i;
    }
  }
  EXPECT_TRUE(faults & kNotFinite);
}

}  // namespace
}  // namespace fulcrum::test
