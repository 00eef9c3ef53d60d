// A pointer on a screen of 1000 x 800 that has edges, and a drag that has none.

#include "engine/ui/wrapped_pointer.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fulcrum::ui {
namespace {

ScreenArea screen() {
  ScreenArea area;
  area.add(-100, -50, 500, 800);
  area.add(400, -50, 500, 800);
  return area;
}

// A hand that moves by (dx, dy) at a time; a jump takes effect `late` events after it was asked for.
WrappedPointer::Place dragged(double dx, double dy, int times, int late) {
  WrappedPointer pointer(300, 300, screen());
  double x = 300, y = 300;
  std::optional<WrappedPointer::Place> asked;
  int wait = 0;
  for (int i = 0; i < times; ++i) {
    if (asked && wait-- <= 0) {
      // From where it was asked for, not from where it is by now.
      x = asked->x;
      y = asked->y;
      asked.reset();
    }
    x = std::clamp(x + dx, -100.0, 899.0);
    y = std::clamp(y + dy, -50.0, 749.0);
    pointer.move(x, y);
    if (const auto to = pointer.jump()) {
      asked = to;
      wait = late;
    }
  }
  return {pointer.x() - 300, pointer.y() - 300};
}

TEST(WrappedPointer, CountsOnBeyondEveryEdge) {
  for (const int late : {0, 3}) {
    EXPECT_NEAR(dragged(13, 0, 400, late).x, 13 * 400, 13 * 40) << late;
    EXPECT_NEAR(dragged(-13, 0, 400, late).x, -13 * 400, 13 * 40) << late;
    EXPECT_NEAR(dragged(0, 7, 400, late).y, 7 * 400, 7 * 40) << late;
    EXPECT_NEAR(dragged(-5, -7, 400, late).y, -7 * 400, 7 * 40) << late;
    EXPECT_EQ(dragged(13, 0, 400, late).y, 0) << late;
  }
}

TEST(WrappedPointer, LosesOnlyWhatTheEdgeSwallows) {
  // At 1 a step and without delay nothing is swallowed but the step onto the edge's pixel.
  EXPECT_NEAR(dragged(1, 0, 2000, 0).x, 2000, 4);
}

TEST(WrappedPointer, AwayFromEdgesItIsThePointer) {
  WrappedPointer pointer(10, 20, screen());
  pointer.move(700, 20);  // farther than half the screen, and no jump
  EXPECT_EQ(pointer.x(), 700);
  EXPECT_FALSE(pointer.jump());
}

TEST(WrappedPointer, WithoutAScreenItNeverJumps) {
  WrappedPointer pointer(0, 0, {});
  pointer.move(0, 0);
  EXPECT_FALSE(pointer.jump());
}

}  // namespace
}  // namespace fulcrum::ui
