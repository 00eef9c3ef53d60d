// Views of piping against goldens, and with the ghost.

#include <gtest/gtest.h>

#include "scene_picture.h"
#include "tests/scenarios/piping/piping.h"

namespace fulcrum::test {
namespace {

TEST(Picture, Piping) {
  for (const char* view : {"overview", "slot", "behind", "above"})
    expect_golden(piping(), input_on_route(piping(), 14.0, 2), view, view);
}

TEST(Picture, PipingWithGhost) {
  app::FrameInput input = input_on_route(piping(), 14.0, 2);
  turn_on(piping(), Vec3::UnitY(), 0.44, input.record);
  for (const char* view : {"overview", "slot", "behind"})
    expect_golden(piping(), input, view, std::string(view) + "_ghost");
}

}  // namespace
}  // namespace fulcrum::test
