// Where the tool is touched, as it is shown: against the regions that the tick itself found, and against a
// wrench that was made up of known pushes.

#include "engine/app/picture/touches.h"

#include <gtest/gtest.h>

#include "engine/app/picture/second_view.h"
#include "engine/app/prepare/prepare.h"
#include "haptics/loop/run_tick.h"

namespace fulcrum::app {
namespace {

struct Touched {
  std::string scenario;
  std::vector<std::string> overrides;
};

class TouchesTest : public testing::TestWithParam<Touched> {};

TEST_P(TouchesTest, AreWhereTheTickFoundThem) {
  const std::optional<Prepared> prepared = prepare(GetParam().scenario, GetParam().overrides);
  ASSERT_TRUE(prepared);
  World world = std::move(*World::build(prepared->haptic.scene));
  const std::unique_ptr<SimulatedDevice> device = std::move(*simulated_device(*prepared, "expert"));
  TouchFinder finder(world.desc());
  int touched = 0, free = 0;
  for (int tick = 0; tick < 12'000; ++tick) {
    TickEvent event;
    run_tick(world, *device, {}, event);
    const double pushed = event.record.contact_F_T_W.force.norm();
    if (pushed == 0) {
      ++free;
      EXPECT_TRUE(finder.find(event.record).empty());
    }
    // One region, pressed firmly; a hand that leaves it in haste is held back by the coupling's damping.
    if (pushed < 0.3 || world.regions().size() != 1) continue;
    const ContactRegion& region = world.regions()[0];
    if (region.nhat_W.dot(event.record.contact_F_T_W.force) < 0.8 * pushed) continue;
    ++touched;
    const std::vector<Touch> touches = finder.find(event.record);
    ASSERT_FALSE(touches.empty()) << tick;
    EXPECT_LT((touches[0].p_W - region.p_W).norm(), 1.5e-3) << tick;
    EXPECT_GT(touches[0].nhat_W.dot(region.nhat_W), 0.99) << tick;
    EXPECT_NEAR(touches[0].force, pushed, 0.05 * pushed) << tick;
  }
  EXPECT_GT(touched, 200);
  EXPECT_GT(free, 200);
}

INSTANTIATE_TEST_SUITE_P(All, TouchesTest,
                         testing::Values(Touched{"stick", {}},
                                         Touched{"plate", {"contact.surface=triangles"}}),
                         [](const auto& each) { return each.param.scenario; });

TEST(Touches, OfARecordWithoutSenseThereAreNone) {
  const std::optional<Prepared> stick = prepare("stick", std::vector<std::string>());
  ASSERT_TRUE(stick);
  TouchFinder finder(stick->haptic.scene);
  TickRecord record;
  record.contact_F_T_W.force = Vec3(0, 1, 0);
  record.X_WT.p = Vec3(0, 50, 0);
  EXPECT_TRUE(finder.find(record).empty()) << "nothing is near";
  record.X_WT.p.setConstant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_TRUE(finder.find(record).empty());
  record.X_WT.p.setZero();
  record.contact_F_T_W.force.x() = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(finder.find(record).empty());
}

const render::Camera kFront{{0.0F, 0.2F, 1.0F}, {0.0F, 0.2F, 0.0F}, 0.8F};

TEST(TouchMarks, StandWhereACameraSeesThemAndGrowWithTheForce) {
  const std::vector<Touch> touches = {{{0, 0.2, 0}, Vec3::UnitY(), 2.0},
                                      {{0.1, 0.2, 0}, Vec3::UnitY(), 0.5},
                                      {{0, 0.2, 3}, Vec3::UnitY(), 1.0}};
  const auto marks = touch_marks(kFront, {1000, 500}, touches, 2.0);
  ASSERT_EQ(marks.size(), 2U) << "one is behind the camera";
  EXPECT_NEAR(marks[0].place.x, 500, 0.01);
  EXPECT_NEAR(marks[0].place.y, 250, 0.01);
  EXPECT_EQ(marks[0].load, 1.0F);
  EXPECT_NEAR(marks[0].place.y - marks[0].tip.y, 50, 0.1) << "upwards, a tenth of the picture";
  EXPECT_NEAR(marks[1].load, 0.25F, 1e-6F);
  EXPECT_LT(marks[1].place.y - marks[1].tip.y, 25);
  const auto parts = in_fractions(marks, {1000, 500});
  EXPECT_NEAR(parts[0].place.x, 0.5F, 1e-4F);
  EXPECT_NEAR(parts[0].tip.y, 0.4F, 1e-3F);
}

TEST(SecondView, IsTheMostSquareOneOfTheScenario) {
  const std::vector<scenario::View> views = {{"front", kFront},
                                             {"half_left", {{-0.9F, 0.2F, 0.6F}, {0, 0.2F, 0}, 0.8F}},
                                             {"from_above", {{0, 2, 0}, {0, 0.2F, 0}, 0.8F}}};
  const ChosenView above = second_view(kFront, views);
  EXPECT_EQ(above.name, "from above");
  EXPECT_EQ(above.camera.eye, views[2].camera.eye);
  EXPECT_EQ(second_view(views[2].camera, views).name, "front");
}

TEST(SecondView, WithoutASquareOneItIsSeenFromTheSide) {
  const std::vector<scenario::View> one = {{"front", kFront}};
  const ChosenView side = second_view(kFront, one);
  EXPECT_EQ(side.name, "from the side");
  EXPECT_NEAR(side.camera.eye.x, 1, 1e-5F);
  EXPECT_NEAR(side.camera.eye.y, 0.2F, 1e-5F);
  EXPECT_NEAR(side.camera.eye.z, 0, 1e-5F);
  // From straight above a quarter turn about the vertical would tell nothing new.
  const render::Camera above{{0, 1.2F, 0}, {0, 0.2F, 0}, 0.8F};
  const ChosenView front = second_view(above, {});
  EXPECT_LT(std::abs(front.camera.eye.y - 0.2F), 0.3F);
  EXPECT_GT(front.camera.eye.z, 0.9F);
}

}  // namespace
}  // namespace fulcrum::app
