// The pointer in either half of a window for two eyes.

#include "engine/app/window/eye_pointer.h"

#include <gtest/gtest.h>

namespace fulcrum::app {
namespace {

constexpr double kAspect = 16.0 / 9.0;

void expect_at(const glm::dvec2& found, double x, double y) {
  EXPECT_NEAR(found.x, x, 1e-12);
  EXPECT_NEAR(found.y, y, 1e-12);
}

TEST(EyePointer, IsWhereItIsWithOnePictureForTheWindow) {
  using enum render::StereoMode;
  for (const std::optional<render::StereoMode> mode :
       {std::optional<render::StereoMode>(), std::optional(interlaced), std::optional(anaglyph)}) {
    EyePointer pointer;
    expect_at(pointer.move(mode, kAspect, {0.2, 0.7}, false).to, 0.2, 0.7);
    const EyePointer::Move moved = pointer.move(mode, kAspect, {1.5, 0.9}, true);
    expect_at(moved.to, 1.5, 0.9);
    expect_at(moved.by, 1.3, 0.2);
  }
}

TEST(EyePointer, PointsAtTheSameFromEitherHalf) {
  EyePointer beside, above;
  expect_at(beside.move(render::StereoMode::side_by_side, kAspect, {0.2, 0.7}, false).to, 0.4, 0.7);
  expect_at(beside.move(render::StereoMode::side_by_side, kAspect, {0.5 * kAspect + 0.2, 0.7}, false).to, 0.4,
            0.7);
  expect_at(above.move(render::StereoMode::top_bottom, kAspect, {0.2, 0.3}, false).to, 0.2, 0.6);
  expect_at(above.move(render::StereoMode::top_bottom, kAspect, {0.2, 0.8}, false).to, 0.2, 0.6);
}

// What is dragged stays under the pointer, which moves half as far over a squeezed picture.
TEST(EyePointer, DragsOnAcrossTheMiddle) {
  EyePointer pointer;
  const auto mode = render::StereoMode::side_by_side;
  pointer.move(mode, kAspect, {0.8, 0.5}, false);
  const EyePointer::Move across = pointer.move(mode, kAspect, {1.0, 0.5}, true);
  expect_at(across.to, 2.0, 0.5);
  expect_at(across.by, 0.4, 0.0);
  expect_at(pointer.move(mode, kAspect, {1.0, 0.5}, false).to, 2.0 * (1.0 - 0.5 * kAspect), 0.5);
}

}  // namespace
}  // namespace fulcrum::app
