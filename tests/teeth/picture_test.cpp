// Views of teeth against goldens, with and without the ghost.

#include <gtest/gtest.h>

#include <stdexcept>

#include "scene_picture.h"

namespace fulcrum::test {
namespace {

const app::Prepared& teeth() {
  static const std::optional<app::Prepared> prepared = app::prepare("teeth", std::vector<std::string>());
  if (!prepared) throw std::runtime_error("teeth could not be prepared");
  return *prepared;
}

/// A view, and when the tool is to be seen in it: at the checkpoint `step`.
struct Shot {
  const char* view;
  double time;  // s
  std::size_t step;
};
constexpr Shot kShots[] = {{"overview", 5.0, 0}, {"molars", 5.0, 0}, {"front", 17.5, 2}};

TEST(Picture, Teeth) {
  for (const Shot& shot : kShots)
    expect_golden(teeth(), moment_on_route(teeth(), shot.time, shot.step), shot.view, shot.view);
}

// The hand has rolled on about the line from the tip, which is held, to the centre of mass.
TEST(Picture, TeethWithGhost) {
  for (const Shot& shot : kShots) {
    app::Moment moment = moment_on_route(teeth(), shot.time, shot.step);
    turn_on(teeth(), teeth().models.p_MT, 0.44, moment.record);
    expect_golden(teeth(), moment, shot.view, std::string(shot.view) + "_ghost");
  }
}

}  // namespace
}  // namespace fulcrum::test
