// Views of tutorial against goldens.

#include <gtest/gtest.h>

#include <stdexcept>

#include "scene_picture.h"

namespace fulcrum::test {
namespace {

const app::Prepared& tutorial() {
  static const std::optional<app::Prepared> prepared = app::prepare("tutorial", std::vector<std::string>());
  if (!prepared) throw std::runtime_error("tutorial could not be prepared");
  return *prepared;
}

constexpr Shot kShots[] = {
    {"overview", 0.2, 0}, {"straight_on", 7.0, 1}, {"side", 12.0, 2}, {"ridges", 16.0, 4}};

TEST(Picture, Tutorial) {
  expect_goldens(tutorial(), kShots);
}

}  // namespace
}  // namespace fulcrum::test
