// The effect in contact, as step() runs it: what is bad, what is shown, what it may not change.

#include "haptics/effects/torque_substitution/torque_substitution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numbers>

#include "tests/haptics/effects/peg.h"

namespace fulcrum::test {
namespace {

constexpr double kJam = 0.0033351934;  // rad, at which the peg jams (ground truth)

// The handle turns from 0 to `angle` within `seconds` and stays there.
StepResult wind(World& world, double angle, double seconds, int ticks, const Vec3& p = Vec3::Zero()) {
  StepResult result;
  for (int i = 1; i <= ticks; ++i) {
    const double part = std::min(1.0, i * world.desc().tick_s / seconds);
    result = step(world, at(turned(part * angle, part * p)), {});
  }
  return result;
}

class InContact : public testing::TestWithParam<ContactResponse> {};

// A pure couple: the peg jams, and the torque is bad from T_min on, whatever R_d.
TEST_P(InContact, APegInASlotIsBadFromTheThresholdOn) {
  SceneDesc desc = peg_scene({.response = GetParam()});
  desc.torque_substitution->bad_above = 0.03;
  desc.torque_substitution->tool_radius = 10;
  const double k = desc.coupling.angular_stiffness;
  for (const double torque : {0.028, 0.033}) {
    World world = expect(World::build(desc));
    // The spring saturates: F_s (1 - exp(-k a / F_s)).
    const double most = desc.coupling.max_torque;
    const double angle = kJam - most / k * std::log1p(-torque / most);
    const StepResult result = wind(world, angle, 0.5, 1500);
    EXPECT_NEAR(result.record.torque_substitution->magnitude, torque, 0.08 * torque);
    EXPECT_EQ(result.record.torque_substitution->bad, torque > 0.03) << torque;
    EXPECT_GT(result.record.regions, 1);
  }
}

// A force along the torque, here against the wall that closes the slot, explains nothing.
TEST_P(InContact, APushAlongTheTorqueDoesNotMakeItGood) {
  SceneDesc desc = peg_scene({.response = GetParam()});
  World world = expect(World::build(desc));
  const StepResult result = wind(world, 0.1, 0.5, 2000, Vec3(0, 0, 0.012));
  EXPECT_GT(result.record.coupling_F_T_W.force.z(), 2.0);
  EXPECT_TRUE(result.record.torque_substitution->bad);
}

// A foot at (r, 0, 0), pressed onto the floor: one force at a lever. Bad just when r > R_d.
TEST_P(InContact, OneFootIsBadWhereItsLeverIsLongerThanTheTool) {
  for (const double r : {0.016, 0.024}) {
    SceneDesc desc = floor_scene({{r, 0, 0}}, 1e-3);
    desc.contact.response = GetParam();
    desc.integrator = Integrator::implicit_euler;
    desc.device.handle_weight = 0;
    desc.torque_substitution.emplace();
    desc.torque_substitution->tool_radius = 0.02;
    desc.torque_substitution->bad_above = 0.005;
    World world = expect(World::build(desc));
    StepResult result;
    for (int i = 0; i < 2000; ++i)
      result = step(world, at({Quat::Identity(), Vec3(0, 1e-3 - std::min(1.0, i / 500.0) * 4e-3, 0)}), {});
    EXPECT_GT(result.record.torque_substitution->magnitude, 0.006);
    EXPECT_EQ(result.record.torque_substitution->bad, r > 0.02) << r;
  }
}

INSTANTIATE_TEST_SUITE_P(Each, InContact,
                         testing::Values(ContactResponse::penalty, ContactResponse::quasi_static,
                                         ContactResponse::constraint),
                         [](const auto& response) -> std::string {
                           if (response.param == ContactResponse::penalty) return "penalty";
                           return response.param == ContactResponse::quasi_static ? "static" : "constraint";
                         });

// The tool's weight hangs on the coupling and has no lever: it must not pass for a force that explains.
TEST(TorqueSubstitution, TheWeightExplainsNothing) {
  SceneDesc desc = peg_scene({});
  desc.tool.weight = true;
  desc.tool_shell = peg_scene({}).tool_shell;
  World world = expect(World::build(desc));
  const double sag = tool_weight(desc.tool) / desc.coupling.stiffness;
  // R_d |weight| is 0.031 N m here, of the size of the torque.
  const StepResult result = wind(world, 0.03, 0.3, 1500, Vec3(0, sag, 0));
  EXPECT_GT(desc.tool_shell->max_radius_m * tool_weight(desc.tool),
            0.8 * result.record.torque_substitution->magnitude);
  EXPECT_TRUE(result.record.torque_substitution->bad);
}

TEST(TorqueSubstitution, VariantsSayWhichCuesAreOn) {
  struct Case {
    TorqueVariant variant;
    bool vibration, ghost;
  };
  for (const Case& c : {Case{TorqueVariant::A, false, false}, Case{TorqueVariant::B, true, false},
                        Case{TorqueVariant::C, true, true}}) {
    SceneDesc desc = peg_scene({});
    desc.torque_substitution->variant = c.variant;
    World world = expect(World::build(desc));
    const StepResult result = wind(world, 1.0, 0.5, 1000);
    EXPECT_TRUE(result.record.torque_substitution->bad);
    EXPECT_EQ(result.record.torque_substitution->vibration > 0, c.vibration);
    EXPECT_EQ(result.record.torque_substitution->ghost > 0, c.ghost);
    EXPECT_EQ(result.command.cues.vibration, result.record.torque_substitution->vibration);
    // The way back, as a person would have to go: 1 rad about z, less what the jammed peg has turned.
    EXPECT_NEAR((result.command.cues.unwind_D - Vec3(0, 0, kJam - 1.0)).norm(), 0, 0.01);
  }
}

TEST(TorqueSubstitution, TheGhostComesAndGoesWithHysteresisAndAFade) {
  SceneDesc desc = peg_scene({});
  desc.torque_substitution->ghost_above = 0.06;
  desc.torque_substitution->ghost_below = 0.04;
  desc.torque_substitution->ghost_fade = 0.1;
  World world = expect(World::build(desc));
  double last = 0;
  int turns = 0, direction = 0;
  for (int i = 0; i < 4000; ++i) {
    // From 0.03 to 0.07 N m and back, twice, with a flutter that crosses each bound many times.
    const double swing = 0.5 - 0.5 * std::cos(2 * std::numbers::pi * i / 2000.0);
    const double angle = 0.022 + 0.03 * swing + 0.0005 * std::sin(0.5 * i);
    const TorqueRecord cues = *step(world, at(turned(angle)), {}).record.torque_substitution;
    EXPECT_LE(std::abs(cues.ghost - last), 0.0100001);
    const int now = cues.ghost > last ? 1 : cues.ghost < last ? -1 : direction;
    turns += now != direction;
    direction = now;
    last = cues.ghost;
  }
  EXPECT_EQ(turns, 4);  // came and went, twice
}

// Gains are commands. A switch in the middle of it fades, and the continuous wrench has no step beyond what
// slew allows.
TEST(TorqueSubstitution, SwitchingInMidRunDoesNotStepTheWrench) {
  SceneDesc desc = peg_scene({});
  desc.torque_substitution->variant = TorqueVariant::A;
  World world = expect(World::build(desc)), untouched = expect(World::build(desc));
  const double slew = desc.device.max_force / kSlewTime * desc.tick_s;
  const double tone = 0.4 / 0.9355 * 2;  // N, the vibration's own largest change
  Vec3 last = Vec3::Zero();
  bool vibrated = false, shown = false;
  for (int i = 0; i < 6000; ++i) {
    const Pose X = turned(std::min(1.0, i / 500.0), Vec3(0.004 * std::sin(i / 200.0), 0, 0));
    std::vector<Command> commands;
    if (i % 500 == 250) commands.push_back({Command::Kind::vibration_gain, i % 1000 == 250 ? 1.0 : 0.0});
    if (i % 700 == 350) commands.push_back({Command::Kind::ghost_gain, i % 1400 == 350 ? 0.5 : 0.0});
    const TickRecord record = step(world, at(X), commands).record;
    EXPECT_LE((record.device_F_H_D.force - last).norm(),
              slew + (record.torque_substitution->vibration > 0 ? tone : 0))
        << i;
    last = record.device_F_H_D.force;
    vibrated |= record.torque_substitution->vibration > 0.3;
    shown |= record.torque_substitution->ghost > 0.49;
    // The handle is held here, so nothing but the vibration may differ from a run in which nobody switched.
    const TickRecord same = step(untouched, at(X), {}).record;
    ASSERT_EQ(record.X_WT.p, same.X_WT.p);
    ASSERT_EQ(record.coupling_F_T_W.torque, same.coupling_F_T_W.torque);
    if (record.torque_substitution->vibration == 0)
      ASSERT_EQ(record.device_F_H_D.force, same.device_F_H_D.force);
  }
  EXPECT_TRUE(vibrated && shown);
}

bool same_bits(double a, double b) {
  return std::memcmp(&a, &b, sizeof a) == 0;
}

// Named but off, against not named: every number that both have, bit for bit (-0 is not 0).
TEST(TorqueSubstitution, OffIsAsIfItWereNotThere) {
  for (const ContactResponse response : {ContactResponse::penalty, ContactResponse::constraint}) {
    SceneDesc off = peg_scene({.response = response});
    off.torque_substitution->variant = TorqueVariant::A;
    off.torque_substitution->limit_stiffness = false;
    SceneDesc none = off;
    none.torque_substitution.reset();
    World a = expect(World::build(off)), b = expect(World::build(none));
    for (int i = 0; i < 3000; ++i) {
      const Pose X = turned(std::min(2.0, i / 500.0), Vec3(0.004 * std::sin(i / 200.0), 0, 0));
      const TickRecord x = step(a, at(X), {}).record, y = step(b, at(X), {}).record;
      for (int axis = 0; axis < 3; ++axis) {
        ASSERT_TRUE(same_bits(x.X_WT.p[axis], y.X_WT.p[axis])) << i;
        ASSERT_TRUE(same_bits(x.coupling_F_T_W.torque[axis], y.coupling_F_T_W.torque[axis])) << i;
        ASSERT_TRUE(same_bits(x.contact_F_T_W.force[axis], y.contact_F_T_W.force[axis])) << i;
        ASSERT_TRUE(same_bits(x.device_F_H_D.force[axis], y.device_F_H_D.force[axis])) << i;
      }
      ASSERT_TRUE(same_bits(x.energy_port, y.energy_port)) << i;
      ASSERT_EQ(x.faults, y.faults) << i;
    }
  }
}

TEST(TorqueSubstitution, IsNotBuiltWhereItHasNoUse) {
  const auto has = [](const SceneDesc& desc, const char* name) {
    return std::ranges::count(part_names(desc), name) == 1;
  };
  SceneDesc desc = peg_scene({});
  EXPECT_TRUE(has(desc, "torque substitution"));
  EXPECT_TRUE(has(desc, "transient budget"));
  SceneDesc torque = desc;
  torque.device.renders_torque = true;
  torque.device.max_torque = 0.2;
  EXPECT_FALSE(has(torque, "torque substitution"));
  EXPECT_FALSE(has(torque, "transient budget"));
  SceneDesc mouse = desc;
  mouse.device.renders_force = false;
  EXPECT_TRUE(has(mouse, "torque substitution"));
  EXPECT_FALSE(has(mouse, "transient budget"));
  SceneDesc plain = desc;
  plain.torque_substitution.reset();
  EXPECT_FALSE(has(plain, "torque substitution"));
  EXPECT_FALSE(has(plain, "transient budget"));
}

// A mouse feels nothing and sees the ghost; a 3/3 device has no turn to show and vibrates.
TEST(TorqueSubstitution, DegradesWithTheDevice) {
  SceneDesc mouse = peg_scene({});
  mouse.device.renders_force = false;
  World of_mouse = expect(World::build(mouse));
  const StepResult clicked = wind(of_mouse, 1.0, 0.5, 1000);
  EXPECT_TRUE(clicked.record.torque_substitution->bad);
  EXPECT_EQ(clicked.record.torque_substitution->vibration, 0.0);
  EXPECT_EQ(clicked.record.torque_substitution->ghost, 1.0);
  SceneDesc three = peg_scene({});
  three.device.senses_rotation = false;
  World of_three = expect(World::build(three));
  const StepResult pushed = wind(of_three, 1.0, 0.5, 1000);  // as if it sensed it, all the same
  EXPECT_GT(pushed.record.torque_substitution->vibration, 0.3);
  EXPECT_EQ(pushed.record.torque_substitution->ghost, 0.0);
}

TEST(TorqueSubstitution, AGhostThatWouldLeaveBeforeItAppearsIsRefused) {
  SceneDesc desc = peg_scene({});
  desc.torque_substitution->bad_above = 0.02;
  desc.torque_substitution->ghost_below = 0.05;  // it appears at twice 0.02
  const Result<World> world = World::build(desc);
  ASSERT_FALSE(world);
  EXPECT_NE(world.error().sentence.find("leaves below 0.05 N m and appears above 0.04 N m"),
            std::string::npos)
      << world.error().sentence;
  desc.torque_substitution->ghost_below = 0.03;
  EXPECT_TRUE(World::build(desc));
}

TEST(TorqueSubstitution, AToneThatTheTickCannotHoldIsRefused) {
  SceneDesc desc = peg_scene({});
  desc.tick_s = 1.0 / 400;
  const Result<World> world = World::build(desc);
  ASSERT_FALSE(world);
  EXPECT_NE(world.error().sentence.find("frequency_Hz is 200; at this tick rate it must be from 80 to 160"),
            std::string::npos)
      << world.error().sentence;
}

}  // namespace
}  // namespace fulcrum::test
