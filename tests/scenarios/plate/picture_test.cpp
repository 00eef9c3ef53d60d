// Views of plate against goldens.

#include <gtest/gtest.h>

#include <stdexcept>

#include "scene_picture.h"

namespace fulcrum::test {
namespace {

const app::Prepared& plate() {
  static const std::optional<app::Prepared> prepared = app::prepare("plate", std::vector<std::string>());
  if (!prepared) throw std::runtime_error("plate could not be prepared");
  return *prepared;
}

constexpr Shot kShots[] = {{"overview", 0.2, 0}, {"faces", 7.45, 4}, {"trainee", 9.15, 5}};

TEST(Picture, Plate) {
  expect_goldens(plate(), kShots);
}

}  // namespace
}  // namespace fulcrum::test
