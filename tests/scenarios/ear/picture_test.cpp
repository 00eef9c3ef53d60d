// Views of the ear against goldens, with and without the ghost.

#include <gtest/gtest.h>

#include <stdexcept>

#include "scene_picture.h"

namespace fulcrum::test {
namespace {

const app::Prepared& ear() {
  static const std::optional<app::Prepared> prepared = app::prepare("ear", std::vector<std::string>());
  if (!prepared) throw std::runtime_error("ear could not be prepared");
  return *prepared;
}

constexpr Shot kShots[] = {{"cutaway", 24.0, 2}, {"outside", 8.0, 0}, {"drum", 30.0, 3}};

TEST(Picture, Ear) {
  expect_goldens(ear(), kShots);
}

TEST(Picture, EarWithGhost) {
  expect_ghost_goldens(ear(), kShots);
}

}  // namespace
}  // namespace fulcrum::test
