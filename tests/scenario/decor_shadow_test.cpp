// A bracket throws a shadow, the wall that it is fixed to does not.

#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>
#include <vector>

#include "engine/render/bounds.h"
#include "engine/scenario/decor_shadows.h"

namespace fulcrum::scenario {
namespace {

// A flat square of this width (m) in the x-y plane, about that place.
void add_square(render::VisualDesc& desc, float width, const glm::vec3& place, bool throws_shadow) {
  const float half = 0.5F * width;
  render::Instance instance;
  instance.mesh = desc.meshes.size();
  instance.X_WM = glm::translate(glm::mat4(1.0F), place);
  instance.casts_shadow = throws_shadow;
  render::Mesh& mesh = desc.meshes.emplace_back();
  mesh.positions = {{-half, -half, 0}, {half, -half, 0}, {half, half, 0}, {-half, half, 0}};
  mesh.normals.assign(4, {0, 0, 1});
  mesh.indices = {0, 1, 2, 0, 2, 3};
  desc.instances.push_back(instance);
}

std::vector<bool> throwing(const render::VisualDesc& desc) {
  std::vector<bool> all;
  for (const render::Instance& instance : desc.instances) all.push_back(instance.casts_shadow);
  return all;
}

TEST(DecorShadows, WhatStandsAmongTheOthersThrowsOne) {
  render::VisualDesc desc;
  add_square(desc, 1.0F, {0, 0, 0}, true);
  add_square(desc, 0.1F, {0.3F, 0, -0.2F}, false);  // a bracket
  add_square(desc, 0.1F, {0.54F, 0, 0}, false);     // a little beside
  add_square(desc, 0.1F, {0.7F, 0, 0}, false);      // far beside
  add_square(desc, 3.0F, {0, 0, -0.3F}, false);     // a wall
  let_decor_throw_shadows(desc);
  EXPECT_EQ(throwing(desc), (std::vector{true, true, true, false, false}));
}

TEST(DecorShadows, AWallAloneThrowsNone) {
  render::VisualDesc desc;
  add_square(desc, 3.0F, {0, 0, 0}, false);
  let_decor_throw_shadows(desc);
  EXPECT_EQ(throwing(desc), std::vector{false}) << "nothing else stands";
  add_square(desc, 4.0F, {0, 0, 1}, true);
  desc.instances.back().movable = true;
  let_decor_throw_shadows(desc);
  EXPECT_EQ(throwing(desc), (std::vector{false, true})) << "what moves is elsewhere the next moment";
}

}  // namespace
}  // namespace fulcrum::scenario
