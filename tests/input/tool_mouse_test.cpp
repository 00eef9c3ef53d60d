// Drags and wheel steps, as seen from a camera that looks along -z.

#include "engine/input/tool_mouse.h"

#include <gtest/gtest.h>

namespace fulcrum::input {
namespace {

// The wheel can bring the tool into a checkpoint of any size, from whatever depth it starts at.
TEST(ToolMouse, WheelStepsFitTheFinestDetail) {
  for (const double radius : {0.0008, 0.001, 0.01}) {
    for (double start = 0; start < 3 * radius; start += 0.1 * radius) {
      for (const Step step : {Step::whole, Step::fine}) {
        ToolMouse mouse(mouse_steps(radius));
        mouse.reset({Quat::Identity(), Vec3(0, 0, start + 10 * radius)});
        int steps = 0;
        while (mouse.X_WH().p.z() > radius / 2 && ++steps < 100) mouse.reach({}, 1, step);
        EXPECT_LE(std::abs(mouse.X_WH().p.z()), radius) << "started " << start;
      }
    }
  }
}

TEST(ToolMouse, AFineStepIsAFractionOfAWholeOne) {
  const MouseSteps steps = mouse_steps(0.0008);
  EXPECT_GT(steps.fine, 0);
  EXPECT_LE(4 * steps.fine, steps.whole);
}

TEST(ToolMouse, SlidesTurnsAndRollsAsSeen) {
  ToolMouse mouse(mouse_steps(0.01));
  mouse.slide({.height = 0.5}, 0.1, 0.2);
  EXPECT_TRUE(mouse.X_WH().p.isApprox(Vec3(0.05, -0.1, 0)));
  mouse.roll({}, 0.1);  // to the right: clockwise, as the person sees it
  EXPECT_LT((mouse.X_WH().q * Vec3::UnitX()).y(), -0.1);
  EXPECT_TRUE((mouse.X_WH().q * Vec3::UnitZ()).isApprox(Vec3::UnitZ()));
  mouse.reset(Pose{});
  mouse.turn({}, 0.1, 0);  // what faces the person goes to the right
  EXPECT_GT((mouse.X_WH().q * Vec3::UnitZ()).x(), 0.1);
}

// By the wheel and by a drag alike: on the way from the eye through the place that has to touch, which stays
// where it is seen, and as much deeper as was asked for, however far to the side it is.
TEST(ToolMouse, ReachesAndPushesAlongTheLineOfSight) {
  const ViewAxes view{.sight_W = Vec3(0.5, -0.2, -1), .height = 0.4};
  ToolMouse wheel(mouse_steps(0.01));
  wheel.reach(view, 3, Step::whole);
  EXPECT_TRUE(wheel.X_WH().p.isApprox(0.03 * view.sight_W));
  ToolMouse drag(mouse_steps(0.01));
  drag.push(view, 0, 0.5);
  EXPECT_TRUE(drag.X_WH().p.isApprox(0.2 * view.sight_W));
  drag.push(view, 0.25, -0.5);
  EXPECT_TRUE(drag.X_WH().p.isApprox(Vec3(0.1, 0, 0)));
}

}  // namespace
}  // namespace fulcrum::input
