// A run's deepest tick, against a count over every tick.

#include "engine/app/run/penetration.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "haptics/bake/field_bake.h"
#include "tests/haptics/bake/shapes.h"

namespace fulcrum::test {
namespace {

constexpr double kTick = 1e-3;

class Course {
public:
  Course()
      : scene_W_(*build_solid(shapes::box({-0.05, -0.02, -0.05}, {0.05, 0, 0.05}))),
        tool_T_(*build_solid(shapes::rotated(shapes::box(Vec3::Constant(-0.005), Vec3::Constant(0.005)),
                                             Quat(Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitX()))))),
        field_(*bake_field(scene_W_, {.voxel_m = 2e-3, .threads = 1})),
        overlap_(scene_W_, tool_T_, &field_) {}

  void tick(const Pose& X_WT, app::PenetrationMeter& meter) {
    TickRecord record;
    record.tick = ticks_++;
    record.X_WT = X_WT;
    meter.note(record);  // depth_max stays 0: the tick itself saw nothing
    const double depth = overlap_.at(X_WT, {.tolerance = 1e-8}).depth;
    if (depth > deepest_) {
      deepest_ = depth;
      at_ = static_cast<double>(record.tick) * kTick;
    }
  }
  app::Penetration measured(const app::PenetrationMeter& meter) const {
    return meter.deepest(scene_W_, tool_T_, &field_);
  }
  double deepest() const { return deepest_; }
  double at() const { return at_; }

private:
  Solid scene_W_, tool_T_;
  DistanceField field_;
  OverlapDepth overlap_;
  std::int64_t ticks_ = 0;
  double deepest_ = 0, at_ = 0;
};

// The tool dips in again and again, each time for a few ticks, once deepest: between the hundredths of a
// second.
TEST(Penetration, TheDeepestTickIsFound) {
  Course run;
  app::PenetrationMeter meter(kTick);
  for (int i = 0; i < 4000; ++i) {
    const double t = i * kTick;
    const double dip = 4e-3 * std::pow(std::sin(9 * t), 20) * (i > 2300 && i < 2700 ? 1.2 : 1.0);
    const Pose X_WT{Quat(Eigen::AngleAxisd(0.2 * std::sin(3 * t), Vec3::UnitY())),
                    {0.01 * std::sin(t), 0.0075 + 2e-3 - dip, 0.01 * std::cos(t)}};
    run.tick(X_WT, meter);
  }
  ASSERT_GT(run.deepest(), 1e-3);
  const app::Penetration found = run.measured(meter);
  EXPECT_NEAR(found.depth, run.deepest(), 1.1e-6);
  EXPECT_LE(found.within, 1.1e-6);
  EXPECT_NEAR(found.at, run.at(), 2.5 * kTick);
}

TEST(Penetration, ARunWithoutContactHasNone) {
  Course run;
  app::PenetrationMeter meter(kTick);
  for (int i = 0; i < 500; ++i) run.tick({Quat::Identity(), {0, 0.03 + 1e-5 * i, 0}}, meter);
  EXPECT_EQ(run.measured(meter).depth, 0.0);
  EXPECT_LE(run.measured(meter).within, 1.1e-6);
  EXPECT_EQ(app::PenetrationMeter(kTick).deepest(Solid{}, Solid{}, nullptr).depth, 0.0);
}

// A minute of swift strokes two millimetres over the scene: a few poses are enough to know that none touched
// it.
TEST(Penetration, SwiftStrokesThatStayClearAreKnownToBeClear) {
  Course run;
  app::PenetrationMeter meter(kTick);
  for (int i = 0; i < 60000; ++i) {
    const double t = i * kTick;
    TickRecord record;
    record.tick = i;
    record.X_WT = {Quat(Eigen::AngleAxisd(std::sin(5 * t), Vec3::UnitX())),
                   {0.04 * std::sin(4 * t), 0.013 + 0.004 * std::sin(3 * t), 0.04 * std::cos(3 * t)}};
    meter.note(record);
  }
  EXPECT_EQ(run.measured(meter).depth, 0.0);
  EXPECT_LE(run.measured(meter).within, 1.1e-6);
}

// A pose that is not a number is the fault's to tell of.
TEST(Penetration, APoseThatIsNotANumberIsPassedOver) {
  Course run;
  app::PenetrationMeter meter(kTick);
  run.tick({Quat::Identity(), {0, 0.005, 0}}, meter);
  TickRecord record;
  record.tick = 1;
  record.X_WT.p.x() = std::nan("");
  meter.note(record);
  EXPECT_NEAR(run.measured(meter).depth, run.deepest(), 1.1e-6);
}

}  // namespace
}  // namespace fulcrum::test
