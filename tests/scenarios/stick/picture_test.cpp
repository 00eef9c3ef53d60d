// Views of stick against goldens.

#include <gtest/gtest.h>

#include <stdexcept>

#include "scene_picture.h"

namespace fulcrum::test {
namespace {

const app::Prepared& stick() {
  static const std::optional<app::Prepared> prepared = app::prepare("stick", std::vector<std::string>());
  if (!prepared) throw std::runtime_error("stick could not be prepared");
  return *prepared;
}

constexpr Shot kShots[] = {{"overview", 0.2, 0}, {"ball", 1.3, 0}, {"trainee", 8.0, 4}};

TEST(Picture, Stick) {
  expect_goldens(stick(), kShots);
}

}  // namespace
}  // namespace fulcrum::test
