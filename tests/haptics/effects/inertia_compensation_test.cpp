// Compensation of a device's inertia, by the formulas it comes from and by what its account must say.

#include "haptics/effects/inertia_compensation/inertia_compensation.h"
#include "tests/haptics/tick_length.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace fulcrum::test {
namespace {

Vec6 motion(const Vec3& moved) {
  Vec6 d;
  d << moved, Vec3::Zero();
  return d;
}

// What the hand feels at G of a force and torque on the handle at C, whose mass m moves with a.
Wrench felt(const Wrench& commanded, const Vec3& p_HG, double mass, const Vec3& a) {
  const Vec3 f_h = commanded.force - mass * a;
  return {f_h, commanded.torque - p_HG.cross(f_h)};
}

// The place of a handle that has moved evenly faster since t = 0.
struct Accelerated {
  InertiaCompensation compensation;
  Vec3 a;
  InertiaCompensation::Tick tick{};
  int n = 0;

  Wrench run(int ticks) {
    Wrench wrench;
    for (int i = 0; i < ticks; ++i, ++n) {
      const double t = n * kTick;
      tick.p_DH = 0.5 * t * t * a;
      tick.open = true;
      wrench = compensation.process(tick);
      const Vec3 moved = n > 0 ? Vec3((t - 0.5 * kTick) * kTick * a) : Vec3(Vec3::Zero());
      compensation.book({}, motion(moved), motion(moved), 0);
    }
    return wrench;
  }
};

Accelerated accelerated(InertiaMethod method, const Vec3& f, const Vec3& p_HG, bool between,
                        double gain = 1) {
  Accelerated handle{{{.method = method, .gain = gain, .budget = 1e3},
                      {.tick_s = kTick, .mass = 0.25, .largest_force = 100}},
                     Vec3(0, 1, 0)};
  handle.tick.force_D = f;
  handle.tick.p_HG_D = p_HG;
  handle.tick.between = between;
  return handle;
}

// m = .25, a = 1, l = .1, h = .03, f = 1: wanted .0300 N m, uncompensated .0475.
TEST(InertiaCompensation, FeltWrenchByEachMethodIsAsPublished) {
  const Vec3 f(0, 1, 0), l(0.1, 0, 0), h(0.03, 0, 0), p_HG = l - h;
  const Wrench rendered{f, l.cross(f)};
  for (const InertiaMethod method : {InertiaMethod::none, InertiaMethod::acceleration}) {
    Accelerated handle = accelerated(method, f, p_HG, false);
    const Wrench added = handle.run(2000);
    const Wrench hand = felt(rendered + added, p_HG, 0.25, handle.a);
    if (method == InertiaMethod::none) {
      EXPECT_NEAR(hand.force.y(), 0.75, 1e-12);
      EXPECT_NEAR(hand.torque.z(), 0.0475, 1e-12);
    } else {
      EXPECT_NEAR((hand.force - f).norm(), 0, 1e-9);  // exact by now: the filter tells even acceleration
      EXPECT_NEAR((hand.torque - h.cross(f)).norm(), 0, 1e-10);
      EXPECT_NEAR(hand.torque.z(), 0.0300, 1e-10);
    }
  }
}

// The contact between hand and stage: the torque about C is h x f, and the force stays.
TEST(InertiaCompensation, ArmCommandsTheTorqueOfAForceAtTheHand) {
  const Vec3 f(0, 1, 0.2), l(0.1, 0, 0), p_HG(0.13, 0, 0), h = l - p_HG;
  Accelerated handle = accelerated(InertiaMethod::arm, f, p_HG, true);
  const Wrench added = handle.run(2000);
  EXPECT_EQ(added.force, Vec3(Vec3::Zero()));
  EXPECT_NEAR((l.cross(f) + added.torque - h.cross(f)).norm(), 0, 1e-15);
  // Eq. 10, its own signs: felt torque -(2 h + l) x f + (h + l) x m a with |h| = .03.
  const Wrench hand = felt({f, l.cross(f) + added.torque}, p_HG, 0.25, handle.a);
  EXPECT_NEAR(hand.torque.z(), -(2 * 0.03 + 0.1) * 1 + (0.03 + 0.1) * 0.25, 1e-12);
  handle.tick.between = false;  // beyond the hand nothing is changed, and it is left within 20 ms
  double before = added.torque.norm();
  for (int i = 0; i < 21; ++i) {
    const double now = handle.run(1).torque.norm();
    EXPECT_LE(before - now, added.torque.norm() / 20 * 1.001);
    before = now;
  }
  EXPECT_EQ(before, 0);
}

// Of an even acceleration the account is empty: all that was given is in the handle's motion.
TEST(InertiaCompensation, LendsTheHandleItsMotion) {
  Accelerated handle = accelerated(InertiaMethod::acceleration, Vec3::Zero(), Vec3::Zero(), false);
  handle.run(3000);
  const double lent = 0.5 * 0.25 * 9;
  EXPECT_NEAR(handle.compensation.record().energy, 0, 0.01 * lent);  // the ramp's part, until g is 1
  const double before = handle.compensation.record().energy;
  handle.run(1000);
  EXPECT_NEAR(handle.compensation.record().energy, before, 1e-3 * lent);
}

// Shaken so fast that the filter is late: the account fills, the gain is gone in 20 ms, and it does not come
// back while the account is full.
TEST(InertiaCompensation, FadesWhereItWouldAddEnergy) {
  InertiaCompensation compensation({.method = InertiaMethod::acceleration},
                                   {.tick_s = kTick, .mass = 0.25, .largest_force = 10});
  Vec3 before = Vec3::Zero();
  int full = -1, gone = -1;
  double given = 0, most = 0;
  Vec3 last = Vec3::Zero();
  for (int i = 0; i < 4000; ++i) {
    const double t = i * kTick;
    InertiaCompensation::Tick tick;
    tick.p_DH = Vec3(0, 3e-3 * std::sin(2 * std::numbers::pi * 5 * t), 0);
    tick.open = true;
    const Vec3 moved = tick.p_DH - before;
    before = tick.p_DH;
    given += last.dot(moved);
    last = compensation.process(tick).force;
    compensation.book({}, motion(moved), motion(moved), 0);
    most = std::max(most, compensation.record().energy);
    if (full < 0 && compensation.record().faded) full = i;
    if (full >= 0 && gone < 0 && compensation.record().gain == 0) gone = i;
  }
  ASSERT_GT(full, 0);
  EXPECT_LE(gone - full, 20);
  EXPECT_TRUE(compensation.record().faded);
  EXPECT_EQ(compensation.record().gain, 0);
  EXPECT_GT(compensation.record().energy, 0.5e-3);
  EXPECT_LT(given, 1.5e-3);  // in all, once nothing is lent any more
  EXPECT_LT(most, 1.5e-3);
}

// What the device's damping takes for certain opens it again; an encoder's flicker takes nothing.
TEST(InertiaCompensation, DampingPaysAndFlickerDoesNot) {
  const auto run = [](const auto& place) {
    InertiaCompensation compensation(
        {.method = InertiaMethod::none},
        {.tick_s = kTick, .mass = 0.25, .damping = 2, .encoder_step = 1e-5, .largest_force = 10});
    double before = place(0);
    for (int i = 0; i < 400; ++i) {
      InertiaCompensation::Tick tick;
      tick.p_DH.x() = place(i);
      tick.open = true;
      compensation.process(tick);
      const Vec3 moved(tick.p_DH.x() - before, 0, 0);
      before = tick.p_DH.x();
      compensation.book({}, motion(moved), motion(moved), 0);
    }
    return compensation.record().energy;
  };
  const double even = run([](int i) { return 1e-2 * i * kTick; });  // at 10 mm/s
  EXPECT_LT(even, 0);
  EXPECT_GE(even, -2 * 1e-4 * 0.4);        // no more than b v^2 t
  EXPECT_LT(even, -0.5 * 2 * 1e-4 * 0.4);  // and most of it
  EXPECT_EQ(run([](int i) { return i % 2 * 1e-5; }), 0);
}

// A late sample tells of a force that was commanded long ago: it is that force whose work is booked.
TEST(InertiaCompensation, BooksTheForceThatALateSampleTellsOf) {
  for (const int late : {0, 1, 5, 20}) {
    InertiaCompensation compensation({.method = InertiaMethod::acceleration, .budget = 1e3},
                                     {.tick_s = kTick, .mass = 0.25, .largest_force = 10});
    std::vector<double> forces;
    double given = 0;
    const auto place = [](double t) { return 1e-3 * std::sin(60 * t); };
    for (int i = 0; i < 3000; ++i) {
      const double t = (i - late) * kTick;
      InertiaCompensation::Tick tick;
      tick.p_DH.y() = place(t);
      tick.open = i > 0;
      const Vec3 moved(0, place(t) - place(t - kTick), 0);
      forces.push_back(compensation.process(tick).force.y());
      compensation.book({}, motion(moved), motion(moved), late * kTick);
      if (i > late) given += forces[static_cast<std::size_t>(i - late - 1)] * moved.y();
    }
    const double lent = 0.5 * 0.25 * std::pow(compensation.filter()->velocity().norm(), 2);
    EXPECT_NEAR(compensation.record().energy, given - lent, 1e-12 + 1e-6 * std::abs(given)) << late;
  }
}

TEST(InertiaCompensation, BuildsTheFilterOnlyWhereItCanBeNeeded) {
  const InertiaCompensation::Figures figures{.mass = 0.25, .largest_force = 1};
  EXPECT_NE(InertiaCompensation({.method = InertiaMethod::arm}, figures).filter(), nullptr);
  InertiaCompensation arm({.method = InertiaMethod::arm, .switchable = false}, figures);
  EXPECT_EQ(arm.filter(), nullptr);
  arm.apply({Command::Kind::compensation, 2});
  EXPECT_EQ(arm.record().method, InertiaMethod::arm);
  InertiaCompensation any({.method = InertiaMethod::none}, figures);
  any.apply({Command::Kind::compensation, 2});
  EXPECT_EQ(any.record().method, InertiaMethod::acceleration);
  for (const double nonsense : {-1.0, 3.0, std::numeric_limits<double>::quiet_NaN(), 1e300})
    any.apply({Command::Kind::compensation, nonsense});
  EXPECT_EQ(any.record().method, InertiaMethod::acceleration);
}

}  // namespace
}  // namespace fulcrum::test
