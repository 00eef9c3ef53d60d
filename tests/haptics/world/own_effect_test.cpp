// An effect from outside haptics/effects passes no limit. Truth: the energy of the port is summed up here,
// from what the device was told and where its handle went.

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <memory>
#include <string>
#include <utility>
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

// Pushes with 1 N, but for one tick.
class NotANumber final : public Own {
public:
  Wrench shape(const EffectTick& tick) noexcept override {
    return {Vec3(tick.tick == 1000 ? std::numeric_limits<double>::quiet_NaN() : 1, 0, 0), Vec3::Zero()};
  }
};

// Asks for what no effect of the scene has a budget for.
class Striker final : public Own {
public:
  std::optional<Transient> strike(const EffectTick& tick) noexcept override {
    if (tick.tick < 1000) return std::nullopt;
    return Transient{TransientSource::braking_pulse, {Vec3(2, 0, 0), Vec3::Zero()}};
  }
};

// Leaves behind the values of `what`, each with its number.
class Telling final : public Own {
public:
  explicit Telling(std::vector<Quantity> what) : what_(std::move(what)) {}
  void record(EffectRecords& records) const noexcept override {
    for (std::size_t i = 0; i < what_.size(); ++i) records.own.add(what_[i], 1.0 + static_cast<double>(i));
  }

private:
  std::vector<Quantity> what_;
};

std::string refused(std::vector<std::vector<Quantity>> told) {
  std::vector<std::unique_ptr<Effect>> own;
  for (auto& what : told) own.push_back(std::make_unique<Telling>(std::move(what)));
  const Result<World> world = World::build(free_scene(), std::move(own));
  return world ? "" : world.error().sentence;
}

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

// Once it has fallen, however that was, it does not come back.
TEST(OwnEffect, ThatGivesNoNumberStopsTheForce) {
  World world = world_with(std::make_unique<NotANumber>());
  const Pose X_DH = world.desc().mapping.handle_in_device({Quat::Identity(), Vec3(0.01, 0.05, 0)});
  std::uint32_t faults = 0;
  double before = 0;
  for (int i = 0; i < 1100; ++i) {
    const StepResult result = step(world, at(X_DH), {});
    ASSERT_TRUE(result.command.F_H_D.is_finite()) << i;
    const double force = result.command.F_H_D.force.norm();
    if (i == 999) EXPECT_NEAR(force, 1, 1e-9);
    if (i >= 1000) EXPECT_LE(force, before) << i;
    before = force;
    faults |= result.record.faults;
    if (i > 1003) {
      EXPECT_TRUE(result.record.stopped) << i;
      EXPECT_EQ(force, 0) << i;
    }
  }
  EXPECT_TRUE(faults & kNotFinite);
}

TEST(OwnEffect, IsToldThatItsTransientsHaveNoBudget) {
  World world = world_with(std::make_unique<Striker>());
  const DeviceSample sample = at(world.desc().mapping.handle_in_device({Quat::Identity(), Vec3(0, 0.05, 0)}));
  for (int i = 0; i < 1000; ++i) EXPECT_EQ(step(world, sample, {}).record.faults & kTransientLimited, 0) << i;
  const StepResult result = step(world, sample, {});
  EXPECT_TRUE(result.record.faults & kTransientLimited);
  EXPECT_EQ(result.command.F_H_D.force.norm(), 0);
  EXPECT_NEAR(result.record.shortfall_F_H_D.force.x(), 2, 1e-9);
}

TEST(OwnEffect, OfSeveralEachHasItsValues) {
  std::vector<std::unique_ptr<Effect>> own;
  own.push_back(std::make_unique<Telling>(std::vector<Quantity>{{"first/a", "1", "", "A."}}));
  own.push_back(std::make_unique<Telling>(
      std::vector<Quantity>{{"second/a", "1", "", "A."}, {"second/b", "1", "", "B."}}));
  const World world = expect(World::build(free_scene(), std::move(own)));
  const TickRecord record = world.blank_record();
  std::vector<std::pair<std::string_view, double>> values;
  for (const auto& [what, value] : record.own.values()) values.emplace_back(what->name, value);
  EXPECT_EQ(values, (std::vector<std::pair<std::string_view, double>>{
                        {"first/a", 1}, {"second/a", 1}, {"second/b", 2}}));
}

TEST(OwnEffect, WhoseColumnsCannotBeIsRefused) {
  const auto value = [](std::string_view name) { return Quantity{name, "1", "", "A number."}; };
  EXPECT_EQ(refused({{value("breeze/force")}}), "");
  EXPECT_EQ(refused({std::vector<Quantity>(9, value("breeze/force"))}).substr(0, 53),
            "The effects from outside have more than 8 values in a");
  EXPECT_TRUE(refused({{value("tool/p/x")}}).starts_with("An effect from outside names a value 'tool/p/x'"));
  EXPECT_TRUE(
      refused({{value("timestamp")}}).starts_with("An effect from outside names a value 'timestamp'"));
  EXPECT_TRUE(refused({{value("breeze/force")}, {value("breeze/force")}})
                  .starts_with("Two values of effects from outside are named 'breeze/force'"));
  std::vector<std::unique_ptr<Effect>> none(1);
  EXPECT_FALSE(World::build(free_scene(), std::move(none)));
}

}  // namespace
}  // namespace fulcrum::test
