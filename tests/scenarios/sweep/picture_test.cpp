// Views of sweep against goldens.

#include <gtest/gtest.h>

#include <stdexcept>

#include "scene_picture.h"

namespace fulcrum::test {
namespace {

const app::Prepared& sweep() {
  static const std::optional<app::Prepared> prepared = app::prepare("sweep", std::vector<std::string>());
  if (!prepared) throw std::runtime_error("sweep could not be prepared");
  return *prepared;
}

constexpr Shot kShots[] = {{"overview", 1.25, 0}, {"finger", 1.3, 0}, {"above", 2.9, 1}};

TEST(Picture, Sweep) {
  expect_goldens(sweep(), kShots);
}

}  // namespace
}  // namespace fulcrum::test
