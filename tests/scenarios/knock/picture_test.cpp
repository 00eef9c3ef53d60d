// Views of knock against goldens.

#include <gtest/gtest.h>

#include <stdexcept>

#include "scene_picture.h"

namespace fulcrum::test {
namespace {

const app::Prepared& knock() {
  static const std::optional<app::Prepared> prepared = app::prepare("knock", std::vector<std::string>());
  if (!prepared) throw std::runtime_error("knock could not be prepared");
  return *prepared;
}

constexpr Shot kShots[] = {{"overview", 0.2, 0}, {"trainee", 8.9, 2}, {"row", 20.9, 6}};

TEST(Picture, Knock) {
  expect_goldens(knock(), kShots);
}

}  // namespace
}  // namespace fulcrum::test
