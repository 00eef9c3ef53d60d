// Views of the nut against goldens: on its way over the pipe, and half way down the thread.

#include <gtest/gtest.h>

#include <stdexcept>

#include "scene_picture.h"

namespace fulcrum::test {
namespace {

const app::Prepared& nut() {
  static const std::optional<app::Prepared> prepared = app::prepare("nut", std::vector<std::string>());
  if (!prepared) throw std::runtime_error("nut could not be prepared");
  return *prepared;
}

constexpr Shot kShots[] = {{"overview", 1.5, 0}, {"behind", 5.0, 1}, {"above", 20.0, 3}};

TEST(Picture, Nut) {
  expect_goldens(nut(), kShots);
}

}  // namespace
}  // namespace fulcrum::test
