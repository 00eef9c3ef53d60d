// Braking pulses in a World: the tip of a stylus, held by the W6D, led onto a floor at a known speed.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "haptics/math/rotation.h"
#include "tests/haptics/actuation/arms.h"
#include "tests/haptics/actuation/w6d.h"
#include "tests/haptics/world/knocks.h"

namespace fulcrum::test {
namespace {

const Vec3 kGrasp(-0.085, 0.085, 0);  // (3) m

SceneDesc plate_scene(ContactResponse response = ContactResponse::constraint) {
  SceneDesc desc = floor_scene({Vec3::Zero()}, 0.01);
  desc.contact.response = response;
  desc.integrator = Integrator::implicit_euler;
  desc.coupling.max_force = 3;
  desc.device = w6d::device(0.511, 0.145);
  desc.device.handle_weight = 0;
  desc.device.mechanism.q_DK = Quat(Eigen::AngleAxisd(-std::numbers::pi / 2, Vec3::UnitY()));
  desc.braking_pulse = BrakingPulseDesc{.p_HG = kGrasp};
  return desc;
}

bool pulses(const TickRecord& record) {
  return !record.braking_pulse->F_H_D.is_zero();
}

void expect_within_limits(const TickRecord& record, const DeviceDesc& device, std::size_t tick) {
  for (const double load : record.actuator_load) ASSERT_LE(std::abs(load), 1.0) << tick;
  ASSERT_TRUE(record.device_F_H_D.is_finite()) << tick;
  ASSERT_LE(record.device_F_H_D.force.norm(), device.max_force * (1 + 1e-9)) << tick;
  ASSERT_LE(record.device_F_H_D.torque.norm(), device.max_torque * (1 + 1e-9)) << tick;
}

class Pulse : public testing::TestWithParam<ContactResponse> {};

// In the tick of contact and in no other; out of the floor; as much as m v / T would need, as far as it goes.
TEST_P(Pulse, ComesInTheTickOfContact) {
  const SceneDesc desc = plate_scene(GetParam());
  const std::vector<TickRecord> records = knock(desc, 3);
  const std::vector<std::size_t> ticks = struck(records);
  ASSERT_EQ(ticks.size(), 3u);
  std::size_t pulsed = 0;
  for (std::size_t i = 0; i < records.size(); ++i) {
    expect_within_limits(records[i], desc.device, i);
    if (!pulses(records[i])) continue;
    ++pulsed;
    EXPECT_TRUE(std::ranges::find(ticks, i) != ticks.end()) << i;
    EXPECT_EQ(records[i - 1].regions, 0);
    EXPECT_GT(records[i].regions, 0);
    const PulseRecord& pulse = *records[i].braking_pulse;
    const double wanted = desc.braking_pulse->hand_mass * kSpeed / desc.tick_s;
    EXPECT_NEAR((pulse.wanted_F_H_D.force - wanted * Vec3::UnitY()).norm(), 0, 2e-3 * wanted);
    EXPECT_NEAR(pulse.F_H_D.force.normalized().y(), 1, 1e-9);
    EXPECT_NEAR(pulse.F_H_D.force.y(), pulse.force_share * pulse.wanted_F_H_D.force.y(), 1e-9);
    EXPECT_GT(pulse.F_H_D.force.y(), 2);
    EXPECT_EQ((records[i].faults & kTransientLimited), 0u);
  }
  EXPECT_EQ(pulsed, 3u);
  EXPECT_LT(records.back().braking_pulse->energy, 0);         // the hand was braked
  EXPECT_EQ(records.back().braking_pulse->moment_energy, 0);  // nothing was turned
}

TEST_P(Pulse, OffIsAsIfItWereNotThere) {
  SceneDesc off = plate_scene(GetParam()), none = off;
  off.braking_pulse->gain = 0;
  none.braking_pulse.reset();
  const auto silent = knock(off, 2), without = knock(none, 2);
  ASSERT_EQ(silent.size(), without.size());
  for (std::size_t i = 0; i < silent.size(); ++i) {
    ASSERT_EQ(bytes_of(silent[i]), bytes_of(without[i])) << i;
    EXPECT_FALSE(without[i].impact_vibration || without[i].braking_pulse);
    EXPECT_FALSE(pulses(silent[i]));
  }
}

INSTANTIATE_TEST_SUITE_P(Each, Pulse,
                         testing::Values(ContactResponse::penalty, ContactResponse::quasi_static,
                                         ContactResponse::constraint),
                         test_name_of);

// Leads the tip through heights above the floor, one a tick, after the force has ramped in at the first.
std::vector<TickRecord> lead(const SceneDesc& desc, const std::vector<double>& heights,
                             const std::vector<Command>& at_start = {}) {
  World world = expect(World::build(desc));
  std::vector<TickRecord> records;
  for (int i = 0; i < 600; ++i) step(world, at(handle(desc, heights.front())), {});
  for (std::size_t i = 0; i < heights.size(); ++i)
    records.push_back(
        step(world, at(handle(desc, heights[i])), i == 0 ? at_start : std::vector<Command>()).record);
  return records;
}

std::size_t count(const std::vector<TickRecord>& records) {
  return static_cast<std::size_t>(std::ranges::count_if(records, pulses));
}

TEST(BrakingPulse, IsArmedAgainThreeMillimetresOff) {
  const auto dip_to = [](double off) {
    std::vector<double> heights(20, 5e-3);
    const auto to = [&heights](double y) {
      const double from = heights.back();
      for (int i = 1; i <= 100; ++i) heights.push_back(from + (y - from) * i / 100);
    };
    for (const double y : {-0.5e-3, off, -0.5e-3, off, -0.5e-3}) to(y);
    return count(lead(plate_scene(), heights));
  };
  EXPECT_EQ(dip_to(2.7e-3), 1u);
  EXPECT_EQ(dip_to(3.3e-3), 3u);
}

TEST(BrakingPulse, LastsItsTicksAndEndsWhenTheHandTurnsBack) {
  SceneDesc desc = plate_scene();
  desc.braking_pulse->ticks = 8;
  std::vector<double> on, back;
  for (int i = 0; i < 60; ++i) on.push_back(2e-3 - 1e-4 * i);
  for (int i = 0; i < 60; ++i) back.push_back(i < 24 ? 2e-3 - 1e-4 * i : -0.3e-3 + 1e-4 * (i - 23));
  const auto led_on = lead(desc, on), led_back = lead(desc, back);
  EXPECT_EQ(count(led_on), 8u);
  EXPECT_LT(count(led_back), 8u);
  EXPECT_GT(count(led_back), 0u);
  double impulse = 0;
  for (const TickRecord& record : led_on) {
    if (!pulses(record)) continue;
    const double wanted = desc.braking_pulse->hand_mass * 0.1 / (8 * desc.tick_s);
    EXPECT_NEAR(record.braking_pulse->wanted_F_H_D.force.y(), wanted, 2e-3 * wanted);
    impulse += desc.tick_s * record.braking_pulse->F_H_D.force.y();
  }
  EXPECT_LE(impulse, desc.braking_pulse->hand_mass * 0.1);
}

// Two feet that strike together are stopped by the momentum of one hand.
TEST(BrakingPulse, PlacesThatAreStruckTogetherShareTheMomentum) {
  SceneDesc desc = plate_scene();
  desc.tool_shell = shell_of({Vec3(0.03, 0, 0), Vec3(-0.03, 0, 0)});
  std::vector<double> heights;
  for (int i = 0; i < 60; ++i) heights.push_back(2e-3 - 1e-4 * i);
  const auto records = lead(desc, heights);
  const double wanted = desc.braking_pulse->hand_mass * 0.1 / desc.tick_s;
  double most = 0;
  for (const TickRecord& record : records) {
    if (record.impact->count > 0) EXPECT_EQ(record.impact->count, 2);
    most = std::max(most, record.braking_pulse->wanted_F_H_D.force.y());
  }
  EXPECT_NEAR(most, wanted, 2e-3 * wanted);
}

TEST(BrakingPulse, OneCommandTurnsTheMomentOffAndOneTheWhole) {
  std::vector<double> heights;
  for (int i = 0; i < 60; ++i) heights.push_back(2e-3 - 1e-4 * i);
  const auto strongest = [](const std::vector<TickRecord>& records) {
    return std::ranges::max(records, {},
                            [](const TickRecord& r) { return r.braking_pulse->F_H_D.force.norm(); });
  };
  const TickRecord both = strongest(lead(plate_scene(), heights));
  const TickRecord force = strongest(lead(plate_scene(), heights, {{Command::Kind::pulse_moment, 0}}));
  const TickRecord none = strongest(lead(plate_scene(), heights, {{Command::Kind::pulse_gain, 0}}));
  EXPECT_GT(both.braking_pulse->F_H_D.torque.norm(), 1e-3);
  EXPECT_NEAR(force.braking_pulse->F_H_D.torque.norm(), 0, 1e-9);
  EXPECT_GT(force.braking_pulse->F_H_D.force.norm(), 3);
  EXPECT_TRUE(none.braking_pulse->F_H_D.is_zero());
  EXPECT_FALSE(force.braking_pulse->moment);
  EXPECT_EQ(none.braking_pulse->gain, 0);
}

// Stiff, fast, light, heavy, long, weak: whatever is asked for, motors keep their limits, the force brakes,
// and no more impulse is given than the hand brought.
TEST(BrakingPulse, ExtremesStayWithinEveryLimit) {
  for (const double speed : {0.02, 0.15, 10.0}) {
    for (const double mass : {1e-6, 0.45, 100.0}) {
      for (const int ticks : {1, 7, 50}) {
        for (const double tick_s : {1e-4, 1e-3, 1e-2}) {
          SceneDesc desc = plate_scene();
          desc.tick_s = tick_s;
          desc.braking_pulse->hand_mass = mass;
          desc.braking_pulse->ticks = ticks;
          desc.coupling = {100, 0.05, 1, 3, 0.1};
          std::vector<double> heights;
          const double start = std::max(5e-3, 4 * speed * tick_s);
          for (int i = 0; i < 400 && start - speed * tick_s * i > -0.02; ++i)
            heights.push_back(start - speed * tick_s * i);
          World world = expect(World::build(desc));
          for (double t = 0; t < 0.6; t += tick_s) step(world, at(handle(desc, start)), {});
          double impulse = 0, within = 0;
          std::vector<double> given;
          for (std::size_t i = 0; i < heights.size(); ++i) {
            const TickRecord record = step(world, at(handle(desc, heights[i])), {}).record;
            expect_within_limits(record, desc.device, i);
            const double J = tick_s * record.braking_pulse->F_H_D.force.y();
            EXPECT_GE(J, -1e-12);
            impulse += J;
            given.push_back(J);
            within += J;
            if (given.size() > static_cast<std::size_t>(0.1 / tick_s))
              within -= given[given.size() - 1 - static_cast<std::size_t>(0.1 / tick_s)];
            EXPECT_LE(within,
                      figures_of(TransientSource::braking_pulse).push * desc.device.max_force * (1 + 1e-6));
          }
          EXPECT_LE(impulse, 1.01 * mass * speed + 1e-15)
              << speed << " m/s " << mass << " kg " << ticks << " x " << tick_s << " s";
        }
      }
    }
  }
}

TEST(BrakingPulse, AMotorWithoutALimitASingularArmAndContactFromTheStart) {
  for (int motor = 0; motor < 3; ++motor) {
    SceneDesc desc = plate_scene();
    desc.device.mechanism.arms[0].joints[static_cast<std::size_t>(motor)].max_torque = 0;
    const auto records = knock(desc, 1);
    for (std::size_t i = 0; i < records.size(); ++i) {
      expect_within_limits(records[i], desc.device, i);
      EXPECT_EQ(records[i].actuator_load[static_cast<std::size_t>(motor)], 0);
    }
  }
  SceneDesc far = plate_scene();  // the arm is stretched to its stops
  far.mapping.X_WD.p = Vec3(0.5, -0.4, -0.6);
  const auto stretched = knock(far, 1);
  for (std::size_t i = 0; i < stretched.size(); ++i) expect_within_limits(stretched[i], far.device, i);

  SceneDesc inside = plate_scene();
  inside.tool.X_WT_start.p.y() = -1e-4;
  EXPECT_EQ(count(lead(inside, std::vector<double>(100, -1e-3))), 0u);
}

// A stop takes a pulse down with the rest within 2 ms, and lets none begin.
TEST(BrakingPulse, AStopEndsItAndLetsNoneBegin) {
  SceneDesc desc = plate_scene();
  desc.braking_pulse->ticks = 50;
  const auto stopped_at = [&desc](int tick) {  // after the handle has set out from 2 mm, 0.1 mm a tick
    World world = expect(World::build(desc));
    for (int i = 0; i < 600; ++i) step(world, at(handle(desc, 2e-3)), {});
    std::vector<TickRecord> records;
    for (int i = 0; i < 60; ++i) {
      const std::vector<Command> commands =
          i == tick ? std::vector<Command>{{Command::Kind::stop}} : std::vector<Command>();
      records.push_back(step(world, at(handle(desc, 2e-3 - 1e-4 * i)), commands).record);
    }
    return records;
  };
  const auto never = stopped_at(-1);
  const auto first = static_cast<int>(std::ranges::find_if(never, pulses) - never.begin());
  ASSERT_LT(first, 50);
  EXPECT_EQ(count(stopped_at(first)), 0u);

  const auto records = stopped_at(first + 5);
  const auto size = [&records](int i) {
    return records[static_cast<std::size_t>(i)].braking_pulse->F_H_D.force.norm();
  };
  EXPECT_GT(size(first + 4), 0.5);
  EXPECT_NEAR(size(first + 5), 0.5 * size(first + 4), 1e-9);
  for (int i = first + 6; i < 60; ++i) EXPECT_NEAR(size(i), 0, 1e-12) << i;
}

// A bar that turns about its middle, against a peg on each side: one pulse each way, none for the other.
TEST(BrakingPulse, BlowsAgainstEachOtherAskForNoMoreThanTheirOwn) {
  BrakingPulse pulse({}, MappingDesc{}, 1e-3);
  const Impact left{.p_W = Vec3(-0.1, 0, 0), .nhat_W = Vec3::UnitY(), .speed = 0.2, .object = 0};
  const Impact right{.p_W = Vec3(0.1, 0, 0), .nhat_W = -Vec3::UnitY(), .speed = 0.2, .object = 0};
  const Impact both[] = {left, right};
  const auto demand = pulse.process(
      {.impacts = both, .X_WG = Pose{}, .V_WG = {Vec3::Zero(), Vec3(0, 0, 2)}, .engaged = true});
  EXPECT_NEAR(demand.F_H_D.force.norm(), 0, 1e-9);
  EXPECT_NEAR(demand.F_H_D.torque.z(), -2 * 0.1 * 0.45 * 0.2 / 1e-3, 1e-9);
}

TEST(BrakingPulse, ADeviceThatPushesAloneBrakesByForce) {
  SceneDesc desc = plate_scene();
  desc.device = arms::phantom();
  desc.device.handle_weight = 0;
  const auto records = knock(desc, 1);
  EXPECT_EQ(count(records), 1u);
  for (std::size_t i = 0; i < records.size(); ++i) {
    EXPECT_TRUE(records[i].device_F_H_D.torque.isZero(0));
    for (const double load : records[i].actuator_load) ASSERT_LE(std::abs(load), 1.0);
  }
  desc.device.renders_force = false;
  desc.device.kinematics = Kinematics::none;
  EXPECT_FALSE(knock(desc, 1).back().braking_pulse);
}

TEST(BrakingPulse, RefusesWhatIsNoHand) {
  const auto refused = [](const auto& spoil) {
    SceneDesc desc = plate_scene();
    spoil(*desc.braking_pulse);
    return !World::build(desc);
  };
  EXPECT_FALSE(refused([](auto&) {}));
  EXPECT_TRUE(refused([](auto& pulse) { pulse.hand_mass = 0; }));
  EXPECT_TRUE(refused([](auto& pulse) { pulse.hand_mass = std::nan(""); }));
  EXPECT_TRUE(refused([](auto& pulse) { pulse.ticks = 0; }));
  EXPECT_TRUE(refused([](auto& pulse) { pulse.ticks = 51; }));
  EXPECT_TRUE(refused([](auto& pulse) { pulse.gain = 1.1; }));
  EXPECT_TRUE(refused([](auto& pulse) { pulse.p_HG.x() = std::nan(""); }));
}

}  // namespace
}  // namespace fulcrum::test
