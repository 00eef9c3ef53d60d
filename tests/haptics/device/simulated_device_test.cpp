// Truths: closed-form oscillators; the Phantom-like figures of Diolaiti, Niemeyer, Barbagli and Salisbury,
// "Stability of haptic rendering", IEEE Trans. Robotics 22(2), 2006.

#include "haptics/device/simulated_device.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace fulcrum {
namespace {

TEST(FrictionAxis, DampedOscillatorIsExactAtAnyTick) {
  // m x'' = -c x' - k x, from x0 at rest: ground truth x(.05 s) = .3118725489962 mm.
  for (double tick : {0.05, 0.01, 1e-3, 1e-4}) {
    FrictionAxis axis{.mass = 0.05, .damping = 2, .friction = 0, .x = 1e-3, .v = 0};
    const int ticks = static_cast<int>(std::lround(0.05 / tick));
    for (int i = 0; i < ticks; ++i) axis.advance({.stiffness = 1000}, tick);
    EXPECT_NEAR(axis.x, 0.3118725489962e-3, 1e-14) << tick;
  }
}

TEST(FrictionAxis, CoulombFrictionStopsASlideWhereTheoryDoes) {
  FrictionAxis axis{.mass = 0.1, .damping = 0, .friction = 0.05, .x = 0, .v = 0.2};
  for (int i = 0; i < 1000; ++i) axis.advance({}, 1e-3);
  EXPECT_EQ(axis.v, 0);
  EXPECT_NEAR(axis.x, 0.1 * 0.2 * 0.2 / (2 * 0.05), 1e-12);  // m v^2 / (2 f_c)
}

TEST(FrictionAxis, SticksUntilTheHandPullsHardEnough) {
  FrictionAxis axis{.mass = 0.1, .damping = 1, .friction = 0.5, .x = 0, .v = 0};
  FrictionAxis::Load load{.stiffness = 100, .hand_x = 0.0049};  // .49 N
  for (int i = 0; i < 100; ++i) axis.advance(load, 1e-3);
  EXPECT_EQ(axis.x, 0);
  load.hand_x = 0.0051;
  for (int i = 0; i < 100; ++i) axis.advance(load, 1e-3);
  EXPECT_GT(axis.x, 0);
}

TEST(FrictionAxis, OneLongTickIsManyShortOnes) {
  FrictionAxis one{.mass = 0.072, .damping = 0.005, .friction = 0.038, .x = 0, .v = 0.03}, many = one;
  const FrictionAxis::Load load{
      .force = -0.1, .stiffness = 300, .hand_damping = 3, .hand_x = 1e-3, .hand_v = 0.05};
  one.advance(load, 0.02);
  FrictionAxis::Load moving = load;
  for (int i = 0; i < 2000; ++i) {
    many.advance(moving, 1e-5);
    moving.hand_x += moving.hand_v * 1e-5;
  }
  EXPECT_NEAR(one.x, many.x, 1e-12);
  EXPECT_NEAR(one.v, many.v, 1e-10);
}

// A wall F = -K x on both sides, encoder steps of 28 um: settles or diverges as published.
double amplitude_after(double K, double v0) {
  SimulatedDeviceDesc desc;
  desc.device = {.handle_mass = 0.072, .damping = 0.005, .friction = 0.038, .encoder_step = 28e-6};
  desc.device.max_force = 1e9;
  SimulatedDevice device(desc, Pose{});
  device.push({v0, 0, 0});
  double largest = 0;
  for (int i = 0; i < 6000; ++i) {
    const double x = device.read().X_DH.p.x();
    device.write({.F_H_D = {Vec3(-K * x, 0, 0), Vec3::Zero()}});
    if (i > 5000) largest = std::max(largest, std::abs(device.X_DH().p.x()));
  }
  return largest;
}

TEST(SimulatedDevice, SampledWallSettlesOrDivergesAsPublished) {
  const auto start = [](double K, double v0) {
    return v0 * std::sqrt(0.072 / K);
  };  // amplitude of the first swing
  EXPECT_LT(amplitude_after(500, 0.1), start(500, 0.1));
  EXPECT_GT(amplitude_after(500, 0.3), start(500, 0.3));
  EXPECT_LT(amplitude_after(1000, 0.05), start(1000, 0.05));
  EXPECT_GT(amplitude_after(1000, 0.2), start(1000, 0.2));
  EXPECT_LT(amplitude_after(2000, 0.02), start(2000, 0.02));
  EXPECT_GT(amplitude_after(2000, 0.1), start(2000, 0.1));
}

TEST(SimulatedDevice, BusDelayAndSampleAgeAreTicks) {
  SimulatedDeviceDesc desc;
  desc.device.friction = 0;
  desc.device.damping = 0;
  desc.device.encoder_step = 0;
  desc.bus_delay_ticks = 2;
  desc.sample_age_ticks = 1;
  SimulatedDevice device(desc, Pose{});
  const DeviceCommand push{.F_H_D = {Vec3(0.72, 0, 0), Vec3::Zero()}};
  device.write(push);
  device.write(push);
  EXPECT_EQ(device.velocity().x(), 0);
  device.write(push);
  EXPECT_NEAR(device.velocity().x(), 0.72 / 0.072 * 1e-3, 1e-12);
  EXPECT_EQ(device.read().X_DH.p.x(), 0);  // a tick old
  EXPECT_EQ(device.read().age, 1e-3);
}

// What the strip says is as old as the pose.
TEST(SimulatedDevice, TheStripIsAsOldAsThePose) {
  SimulatedDeviceDesc desc;
  desc.device.strip.emplace();
  const HandTask task{.path = HandPath({{.X_WT = Pose{}, .travel = 0, .dwell = 0, .hold = 0.05},
                                        {.X_WT = Pose{}, .travel = 0.1, .hold = 0.15}}),
                      .hand = {},
                      .X_HT = Pose{},
                      .mapping = {}};
  SimulatedDevice fresh(desc, task);
  desc.sample_age_ticks = 3;
  SimulatedDevice late(desc, task);
  std::vector<double> ohm;
  for (int i = 0; i < 50; ++i) {
    ohm.push_back(fresh.read().strip_ohm);
    EXPECT_EQ(late.read().strip_ohm, i < 3 ? kStripOpen : ohm[static_cast<std::size_t>(i) - 3]) << i;
    fresh.write({});
    late.write({});
  }
  EXPECT_GT(ohm[49], ohm[10] + 100);
}

TEST(SimulatedDevice, EncodersStepAndDoNotDrift) {
  SimulatedDeviceDesc desc;
  desc.device.angular_friction = 0;
  SimulatedDevice device(desc, Pose{});
  device.push({0.013, 0, 0});
  for (int i = 0; i < 300; ++i) {
    device.write({.F_H_D = {Vec3::Zero(), Vec3::Zero()}});
    const double steps = device.read().X_DH.p.x() / desc.device.encoder_step;
    EXPECT_NEAR(steps, std::round(steps), 1e-9);
    EXPECT_LE(std::abs(device.read().X_DH.p.x() - device.X_DH().p.x()), 0.5001 * desc.device.encoder_step);
  }
}

// At a 60 ms stall a held force leaves only 17.5 N/m stable; a decaying one does no such
// harm.
TEST(SimulatedDevice, ForceHeldThroughAStallDecays) {
  SimulatedDeviceDesc desc;
  desc.device = {.handle_mass = 0.1, .damping = 0.5, .friction = 0, .encoder_step = 0};
  SimulatedDevice device(desc, Pose{});
  device.write({.F_H_D = {Vec3(1, 0, 0), Vec3::Zero()}});
  const double before = device.velocity().x();
  device.miss(60);
  EXPECT_LT(device.velocity().x() - before, 1.0 / 0.1 * 5e-3);
}

TEST(HandPath, TravelsOnAMinimumJerkProfileAndRests) {
  const Pose a{Quat::Identity(), Vec3::Zero()}, b{Quat::Identity(), Vec3(1, 0, 0)};
  const HandPath path({{a, 1, 0.5}, {b, 2, 3}});
  EXPECT_EQ(path.at(0.4).p.x(), 0);
  EXPECT_NEAR(path.at(1.5).p.x(), 0.5, 1e-12);
  EXPECT_EQ(path.at(2.5).p.x(), 1);
  EXPECT_EQ(path.duration(), 5.5);
  EXPECT_NEAR((path.at(1.5 + 1e-4).p.x() - path.at(1.5).p.x()) / 1e-4, 1.875 / 2, 1e-4);  // peak speed
}

TEST(Tremor, HasTheStatedRmsAndTheSeedDecides) {
  HandDesc desc;
  const Tremor tremor(desc);
  double sum = 0;
  const int n = 60000;
  for (int i = 0; i < n; ++i) sum += std::pow(tremor.at(i * 1e-3)[0], 2);
  EXPECT_NEAR(std::sqrt(sum / n), desc.tremor, 0.15 * desc.tremor);
  EXPECT_EQ(tremor.at(1.0), Tremor(desc).at(1.0));
  desc.seed = 2;
  EXPECT_NE(tremor.at(1.0), Tremor(desc).at(1.0));
}

// A hand that somebody else stopped rests where it is, and goes on as if nothing had been.
TEST(SimulatedDevice, ItsHandWaitsWhileSomebodyHasStoppedIt) {
  const auto made = [] {
    const Pose there{Quat::Identity(), Vec3(0.1, 0, 0)};
    HandTask task{.path = HandPath(std::vector<Waypoint>{{.X_WT = {}}, {.X_WT = there, .travel = 1}}),
                  .hand = {.tremor = 0, .tremor_rad = 0},
                  .X_HT = {},
                  .mapping = {}};
    return SimulatedDevice({}, std::move(task));
  };
  SimulatedDevice stopped = made(), other = made();
  DeviceCommand pause;
  pause.cues.paused = true;
  for (int tick = 0; tick < 500; ++tick) {
    stopped.write({});
    other.write({});
  }
  for (int tick = 0; tick < 1000; ++tick) stopped.write(pause);
  EXPECT_NEAR(stopped.X_DH().p.x(), 0.05, 1e-3) << "half of the way";
  for (int tick = 0; tick < 1000; ++tick) {
    stopped.write({});
    other.write({});
  }
  EXPECT_NEAR((stopped.X_DH().p - other.X_DH().p).norm(), 0, 1e-5);
  EXPECT_NEAR(stopped.X_DH().p.x(), 0.1, 1e-3);
}

// A hand that stops the force where its path says so: the one button from its arrival on, then the other
// until it leaves.
TEST(SimulatedDevice, ItsHandStopsWhereItsPathSaysSo) {
  const Pose there{Quat::Identity(), Vec3(0.1, 0, 0)};
  HandTask task{
      .path = HandPath(std::vector<Waypoint>{{.X_WT = {}, .dwell = 0.2},
                                             {.X_WT = there, .travel = 0.3, .dwell = 0.5, .stop = 0.1},
                                             {.X_WT = {}, .travel = 0.3}}),
      .hand = {},
      .X_HT = {},
      .mapping = {}};
  SimulatedDevice device({}, std::move(task));
  std::vector<std::uint32_t> buttons;
  for (int tick = 0; tick < 1500; ++tick) {
    buttons.push_back(device.read().buttons);
    device.write({});
  }
  // A tick is added up to its time, so that an edge may fall a tick beside.
  const auto expect = [&](int from, int to, std::uint32_t down) {
    for (int tick = from + 1; tick < to - 1; ++tick)
      ASSERT_EQ(buttons[static_cast<std::size_t>(tick)], down) << tick;
  };
  expect(-1, 500, 0);
  expect(500, 600, kHandStopButton);
  expect(600, 1000, kHandGoButton);
  expect(1000, 1500, 0);
}

}  // namespace
}  // namespace fulcrum
