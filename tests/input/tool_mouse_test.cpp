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

}  // namespace
}  // namespace fulcrum::input
