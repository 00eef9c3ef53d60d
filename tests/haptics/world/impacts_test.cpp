// Impacts and their vibration in a World: a tool on a lever over the floor, led by a handle at a known speed.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "haptics/math/rotation.h"
#include "tests/haptics/scenes.h"
#include "tests/haptics/world/knocks.h"

namespace fulcrum::test {
namespace {

constexpr double kTip = 0.12;  // m, from the handle to the tool's tip, along x

DeviceDesc six_axis() {
  DeviceDesc device;
  device.renders_torque = true;
  device.max_torque = 2;  // a press at the lever leaves room
  device.handle_weight = 0;
  return device;
}

SceneDesc knock_scene(ContactResponse response) {
  SceneDesc desc = floor_scene({Vec3::Zero()}, 0.01);
  desc.contact.response = response;
  desc.integrator = Integrator::implicit_euler;
  desc.tool.X_HT.p = Vec3(kTip, 0, 0);
  desc.device = six_axis();
  desc.mapping.X_WD.q = quaternion_exp(Vec3(0.3, -0.8, 0.5));
  desc.impact_vibration.emplace();
  return desc;
}

class Impacts : public testing::TestWithParam<ContactResponse> {};

// Axis, frequency, speed, place and onset as they must be; each blow once.
TEST_P(Impacts, EachBlowIsFeltFromTheNextTickOn) {
  const SceneDesc desc = knock_scene(GetParam());
  const std::vector<TickRecord> records = knock(desc, 3);
  const std::vector<std::size_t> ticks = struck(records);
  ASSERT_EQ(ticks.size(), 3u);
  const std::size_t at = ticks[0];
  const Impact& impact = records[at].impact->hardest;
  EXPECT_NEAR(impact.speed, kSpeed, 1e-3 * kSpeed);
  EXPECT_LT(impact.p_W.norm(), 0.3e-3);
  EXPECT_NEAR(impact.nhat_W.y(), 1, 1e-6);
  EXPECT_TRUE(records[at].impact_vibration->F_H_D.is_zero());
  EXPECT_FALSE(records[at + 1].impact_vibration->F_H_D.is_zero());

  const double d = 5, w = 2 * std::numbers::pi * 12;  // the tip is the tool's reach
  EXPECT_NEAR(records[at].impact_vibration->frequency_Hz, 12, 0.12);
  const double amplitude = 0.8 * impact.speed;  // of steel
  const Vec3 axis_D = desc.mapping.X_WD.q.conjugate() * Vec3::UnitZ();
  for (std::size_t n = 1; n < 200; ++n) {
    const Wrench& F = records[at + n].impact_vibration->F_H_D;
    const double g = amplitude * std::exp(-d * 1e-3 * static_cast<double>(n)) *
                     std::sin(w * 1e-3 * static_cast<double>(n));
    ASSERT_NEAR(F.torque.norm(), kTip * std::abs(g), 0.01 * kTip * amplitude) << n;
    if (std::abs(g) > 1e-3 * amplitude)
      EXPECT_GT(std::abs(F.torque.normalized().dot(axis_D)), std::cos(std::numbers::pi / 180)) << n;
  }
}

// The wrench on the handle is the continuous one and the vibration, and off it is as if it were not there:
// every number that both have, bit for bit (-0 is not 0).
TEST_P(Impacts, OffIsAsIfTheyWereNotThere) {
  const SceneDesc on = knock_scene(GetParam());
  SceneDesc off = on, none = on;
  off.impact_vibration->gain = 0;
  none.impact_vibration.reset();
  const auto with = knock(on, 2), silent = knock(off, 2), without = knock(none, 2);
  ASSERT_EQ(silent.size(), without.size());
  double most = 0;
  for (std::size_t i = 0; i < silent.size(); ++i) {
    ASSERT_EQ(bytes_of(silent[i]), bytes_of(without[i])) << i;
    EXPECT_FALSE(without[i].impact || without[i].impact_vibration);
    const Wrench& F = with[i].impact_vibration->F_H_D;
    most = std::max(most, F.torque.norm());
    EXPECT_LT((with[i].device_F_H_D.torque - without[i].device_F_H_D.torque - F.torque).norm(), 1e-15);
    EXPECT_LT((with[i].device_F_H_D.force - without[i].device_F_H_D.force - F.force).norm(), 1e-14);
    EXPECT_TRUE(silent[i].impact_vibration->F_H_D.is_zero());
  }
  EXPECT_EQ(struck(silent), struck(with)) << "impacts are found all the same";
  EXPECT_GT(most, 0.005);
}

TEST_P(Impacts, ContactOnTheFirstTickIsNone) {
  const std::vector<TickRecord> records = knock(knock_scene(GetParam()), 1, -0.5e-3);
  EXPECT_TRUE(struck(records).empty());
}

INSTANTIATE_TEST_SUITE_P(Each, Impacts,
                         testing::Values(ContactResponse::penalty, ContactResponse::quasi_static,
                                         ContactResponse::constraint),
                         test_name_of);

// A table's four feet strike in one tick, as four impacts.
TEST(ImpactsInAWorld, ManyAtOnce) {
  SceneDesc desc = knock_scene(ContactResponse::constraint);
  desc.tool_shell = shell_of({{0.03, 0, 0.03}, {-0.03, 0, 0.03}, {0.03, 0, -0.03}, {-0.03, 0, -0.03}});
  const std::vector<TickRecord> records = knock(desc);
  EXPECT_EQ(struck(records).size(), 4u);
  EXPECT_EQ(records.back().impact_vibration->dropped, 0);
}

TEST(ImpactsInAWorld, TellWhichObjectWasStruck) {
  SceneDesc desc = knock_scene(ContactResponse::constraint);
  const std::vector<Vec3> samples{{-0.05, 0, 0}, {0.05, 0, 0}};
  for (const std::int32_t object : {0, 1}) {
    desc.scene_objects = std::make_shared<const ObjectMap>(
        samples, std::vector<std::int32_t>{object == 0 ? 0 : 1, object == 0 ? 1 : 0});
    desc.tool_shell = shell_of({{-0.02, 0, 0}});
    const std::vector<TickRecord> records = knock(desc);
    const std::vector<std::size_t> ticks = struck(records);
    ASSERT_EQ(ticks.size(), 1u);
    EXPECT_EQ(records[ticks[0]].impact->hardest.object, object);
  }
}

// 10 m/s and all tools heavy or light: finite, within the device's limits, within the budget.
TEST(ImpactsInAWorld, HardBlowsStayWithinLimits) {
  for (const ContactResponse response : {ContactResponse::penalty, ContactResponse::constraint}) {
    const SceneDesc desc = knock_scene(response);
    World world = expect(World::build(desc));
    for (int i = 0; i < 600; ++i) step(world, at(handle(desc, 0.05)), {});
    for (int i = 0; i < 2000; ++i) {
      const double y = 0.02 + 0.03 * std::sin(0.3333 * i);  // 10 m/s
      const TickRecord record = step(world, at(handle(desc, y)), {}).record;
      ASSERT_TRUE(record.device_F_H_D.is_finite());
      ASSERT_LE(record.device_F_H_D.force.norm(), desc.device.max_force * (1 + 1e-12));
      ASSERT_LE(record.device_F_H_D.torque.norm(), desc.device.max_torque * (1 + 1e-12));
      const double peak = figures_of(TransientSource::impact_vibration).peak;
      ASSERT_LE(record.impact_vibration->F_H_D.torque.norm(), peak * desc.device.max_torque * (1 + 1e-12));
    }
  }
}

TEST(ImpactsInAWorld, AreNotBuiltWhereNothingAsks) {
  const auto has = [](const SceneDesc& desc, const char* name) {
    return std::ranges::count(part_names(desc), name) == 1;
  };
  SceneDesc desc = knock_scene(ContactResponse::constraint);
  for (const char* part : {"impacts", "impact vibration", "impact budget"}) {
    EXPECT_TRUE(has(desc, part)) << part;
    SceneDesc mouse = desc;
    mouse.device.renders_force = mouse.device.renders_torque = false;
    EXPECT_FALSE(has(mouse, part)) << part;
    SceneDesc plain = desc;
    plain.impact_vibration.reset();
    EXPECT_FALSE(has(plain, part)) << part;
  }
}

TEST(ImpactsInAWorld, RefuseFiguresThatMakeNoSense) {
  const auto refused = [](const auto& change) {
    SceneDesc desc = knock_scene(ContactResponse::constraint);
    change(desc);
    return !World::build(desc);
  };
  EXPECT_TRUE(refused([](SceneDesc& desc) { desc.impact_vibration->voices = 0; }));
  EXPECT_TRUE(refused([](SceneDesc& desc) { desc.impact_vibration->voices = ImpactVoices::kMax + 1; }));
  EXPECT_TRUE(refused([](SceneDesc& desc) { desc.impact_vibration->gain = 1.1; }));
  EXPECT_TRUE(refused([](SceneDesc& desc) { desc.impact_vibration->materials.clear(); }));
  EXPECT_TRUE(refused([](SceneDesc& desc) { desc.impact_vibration->materials[0].decay = 0; }));
  EXPECT_TRUE(refused([](SceneDesc& desc) { desc.impact_vibration->materials[0].frequency_Hz = NAN; }));
  EXPECT_TRUE(refused([](SceneDesc& desc) { desc.impact_vibration->hand_stiffness = 0; }));
  EXPECT_TRUE(refused([](SceneDesc& desc) { desc.impact.retreat = 0; }));
}

}  // namespace
}  // namespace fulcrum::test
