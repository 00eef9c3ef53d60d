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

constexpr Shot kShots[] = {{"overview", 0.2, 0}, {"faces", 9.1, 5}, {"trainee", 4.05, 2}};

TEST(Picture, Plate) {
  expect_goldens(plate(), kShots);
}

}  // namespace
}  // namespace fulcrum::test
