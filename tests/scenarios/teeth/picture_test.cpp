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

constexpr Shot kShots[] = {{"overview", 5.0, 0}, {"molars", 5.0, 0}, {"front", 17.5, 2}};

TEST(Picture, Teeth) {
  expect_goldens(teeth(), kShots);
}

TEST(Picture, TeethWithGhost) {
  expect_ghost_goldens(teeth(), kShots);
}

}  // namespace
}  // namespace fulcrum::test
