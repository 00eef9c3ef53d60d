// What must not be felt: how densely the tool is sampled, and where regions meet.

#include "haptics/contact/penalty.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "haptics/contact/query.h"
#include "haptics/contact/regions.h"
#include "tests/haptics/scenes.h"

namespace fulcrum {
namespace {

const RigidBody kTool(0.2, Mat3::Identity() * 1e-4);

// A square patch, `side` m wide about (x, 0, 0), pressed 0.2 mm into a floor; n points along each side.
void add_patch(ContactSet& set, double x, double side, int n) {
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      Contact contact;
      contact.p_W = Vec3(x + side * ((i + 0.5) / n - 0.5), 0, side * ((j + 0.5) / n - 0.5));
      contact.nhat_W = Vec3::UnitY();
      contact.depth = 0.2e-3;
      contact.overlap = Overlap::of(side * side / n / n, contact.depth, contact.p_W);
      set.add(contact);
    }
  }
}

double force(const ContactSet& set, Integrator integrator = Integrator::implicit_euler) {
  ContactDesc desc;
  desc.stiffness = 1000;
  PenaltyResponse response(desc, kTool, 1e-3, integrator);
  return response.push(set, {}).F_T_W.force.y();
}

TEST(Penalty, OnePointIsOneSpring) {
  ContactSet set;
  add_patch(set, 0, 1e-3, 1);
  EXPECT_NEAR(force(set), 1000 * 0.2e-3, 1e-12);
}

TEST(Penalty, SamplingIsNotFelt) {
  ContactSet coarse, fine;
  add_patch(coarse, 0, 6e-3, 4);
  add_patch(fine, 0, 6e-3, 12);
  EXPECT_NEAR(force(fine) / force(coarse), 1.0, 0.02);
}

// A ball of 2 cm pressed a millimetre into the floor; n points spread evenly over the part of it that
// touches.
double pressed_ball(int n, bool& complete) {
  std::vector<Vec3> points;
  const double golden = std::numbers::pi * (3 - std::sqrt(5.0));
  for (int i = 0; i < n; ++i) {
    const double y = -0.02 + 1e-3 * (i + 0.5) / n, r = std::sqrt(0.02 * 0.02 - y * y);
    points.emplace_back(r * std::cos(golden * i), y, r * std::sin(golden * i));
  }
  ContactQuery query(test::shell_of(points), test::floor_field());
  ContactSet set;
  complete = query.run({Quat::Identity(), Vec3(0, 0.019, 0)}, set).complete;
  return force(set);
}

TEST(Penalty, TakingPointsTogetherIsNotFelt) {
  bool complete = false;
  const double one_by_one = pressed_ball(250, complete);
  EXPECT_TRUE(complete);
  for (const int n : {500, 2000, 8000, 60000}) {
    EXPECT_NEAR(pressed_ball(n, complete) / one_by_one, 1.0, 0.02) << n;
    EXPECT_FALSE(complete);
  }
}

TEST(Penalty, PlacesFarApartAreASpringEachAndMeetSmoothly) {
  double before = 0;
  for (double apart = 0; apart < 0.03; apart += 1e-4) {
    ContactSet set;
    add_patch(set, -0.5 * apart, 1e-3, 2);
    add_patch(set, 0.5 * apart, 1e-3, 2);
    const double now = force(set);
    if (apart > 0) EXPECT_LT(std::abs(now - before), 0.02 * 0.2) << apart;
    before = now;
  }
  EXPECT_NEAR(before, 2 * force([] {
                        ContactSet one;
                        add_patch(one, 0, 1e-3, 2);
                        return one;
                      }()),
              1e-9);
}

TEST(Penalty, SemiImplicitEulerGetsNoMoreThanTheTickCanHold) {
  ContactSet set;
  for (int i = 0; i < 10; ++i) add_patch(set, 0.02 * i, 1e-3, 1);
  ContactDesc desc;
  desc.stiffness = 1e6;
  PenaltyResponse response(desc, kTool, 1e-3, Integrator::semi_implicit_euler);
  EXPECT_TRUE(response.push(set, {}).stiffness_capped);
}

TEST(Penalty, NeverPulls) {
  ContactSet set;
  add_patch(set, 0, 1e-3, 1);
  PenaltyResponse response({}, kTool, 1e-3, Integrator::implicit_euler);
  BodyState leaving;
  leaving.V_WT.v = Vec3(0, 5, 0);
  EXPECT_EQ(response.push(set, leaving).F_T_W.force.y(), 0);
}

TEST(Regions, KeepTheirIdentityWhileTouched) {
  RegionTracker tracker(0.012);
  std::vector<Vec3> forces(8, Vec3::Zero());
  std::uint32_t left = 0, right = 0;
  for (int tick = 0; tick < 50; ++tick) {
    ContactSet set;  // two places that wander, told in changing order
    add_patch(set, (tick % 2 ? 1 : -1) * 0.03 + 1e-4 * tick, 2e-3, 2);
    add_patch(set, (tick % 2 ? -1 : 1) * 0.03 + 1e-4 * tick, 2e-3, 2);
    tracker.update(set.contacts(), forces, {});
    ASSERT_EQ(tracker.regions().size(), 2u);
    for (const ContactRegion& region : tracker.regions()) {
      std::uint32_t& id = region.p_W.x() < 0 ? left : right;
      if (tick == 0) id = region.id;
      EXPECT_EQ(region.id, id);
      EXPECT_EQ(region.age_ticks, tick);
    }
  }
  tracker.update({}, {}, {});
  ContactSet again;
  add_patch(again, 0.03, 2e-3, 2);
  tracker.update(again.contacts(), forces, {});
  EXPECT_NE(tracker.regions()[0].id, right) << "a new touch is a new region";
}

}  // namespace
}  // namespace fulcrum
