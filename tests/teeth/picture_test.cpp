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

constexpr const char* kViews[] = {"overview", "molars", "front"};

TEST(Picture, Teeth) {
  for (const char* view : kViews) expect_golden(teeth(), moment_on_route(teeth(), 14.0), view, view);
}

// The hand has rolled on about the handle while the tip is held between two teeth.
TEST(Picture, TeethWithGhost) {
  app::Moment moment = moment_on_route(teeth(), 14.0);
  moment.ghost = turned_on(moment.record.X_WT, Vec3(0.4, 1, 0), 0.44);
  for (const char* view : kViews) expect_golden(teeth(), moment, view, std::string(view) + "_ghost");
}

}  // namespace
}  // namespace fulcrum::test
