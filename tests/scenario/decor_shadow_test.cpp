// A bracket throws a shadow, the wall that it is fixed to does not.

#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>
#include <vector>

#include "engine/scenario/decor_shadows.h"

namespace fulcrum::scenario {
namespace {

// The map is as wide as things are in the x-y plane, where this light comes from +z.
render::KeyLight from_before() {
  render::KeyLight light;
  light.direction = {0, 0, -1};
  return light;
}

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
  desc.materials = {{"matt"}};
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
  let_decor_throw_shadows(desc, from_before());
  EXPECT_EQ(throwing(desc), (std::vector{true, true, true, false, false}));
}

// Through it light passes, so that it takes nothing of the tenth that the others may have.
TEST(DecorShadows, GlassThrowsNone) {
  render::VisualDesc desc;
  add_square(desc, 1.0F, {0, 0, 0}, true);
  add_square(desc, 0.1F, {0.52F, 0, 0}, false);
  add_square(desc, 0.2F, {-0.48F, 0, 0}, false);
  desc.materials.push_back({"glass", glm::vec3(1.0F), 0.0F, 0.1F, render::SurfaceDetail{}});
  desc.materials[1].detail->transmission = 1.0F;
  desc.instances[1].material = 1;
  let_decor_throw_shadows(desc, from_before());
  EXPECT_EQ(throwing(desc), (std::vector{true, false, true}));
}

// Whichever of them comes first, and however many there are, the map is no wider than a tenth more.
TEST(DecorShadows, TogetherTheyWidenTheMapByATenthAtTheMost) {
  render::VisualDesc desc;
  add_square(desc, 1.0F, {0, 0, 0}, true);
  add_square(desc, 0.2F, {0.46F, 0, 0}, false);
  add_square(desc, 0.1F, {-0.54F, 0, 0}, false);
  let_decor_throw_shadows(desc, from_before());
  EXPECT_EQ(throwing(desc), (std::vector{true, false, true}))
      << "0.06 and 0.09 m wider, the smaller one first";
}

// A rod lying along the light is a point to it: what is as large as the rod is long is large.
TEST(DecorShadows, WhatTheLightSeesOfThemCounts) {
  render::VisualDesc desc;
  add_square(desc, 0.1F, {0, 0, 0}, true);
  add_square(desc, 0.1F, {0, 0, 3.0F}, true);
  add_square(desc, 2.0F, {0, 0, 1.5F}, false);
  let_decor_throw_shadows(desc, from_before());
  EXPECT_FALSE(desc.instances[2].casts_shadow);
}

TEST(DecorShadows, WhatIsSeenThroughMakesRoomForNone) {
  render::VisualDesc desc;
  add_square(desc, 0.1F, {0, 0, 0}, true);
  add_square(desc, 2.0F, {0, 0, 0.1F}, true);
  add_square(desc, 2.0F, {0, 0, -0.1F}, false);
  desc.materials.push_back({"glass"});
  desc.materials[1].detail.emplace().transmission = 1.0F;
  desc.instances[1].material = 1;
  let_decor_throw_shadows(desc, from_before());
  EXPECT_FALSE(desc.instances[2].casts_shadow);
}

TEST(DecorShadows, WhatALampStandsInLeavesItsLight) {
  render::KeyLight lamp = from_before();
  lamp.kind = render::KeyLight::Kind::spot;
  lamp.position = {0.2F, 0.2F, 0.5F};
  render::VisualDesc desc;
  add_square(desc, 1.0F, {0, 0, 0}, true);
  add_square(desc, 0.5F, {0.2F, 0.2F, 0.5F}, false);
  add_square(desc, 0.5F, {0.2F, 0.2F, 0.2F}, false);
  let_decor_throw_shadows(desc, lamp);
  EXPECT_EQ(throwing(desc), (std::vector{true, false, true}));
}

TEST(DecorShadows, AWallAloneThrowsNone) {
  render::VisualDesc desc;
  add_square(desc, 3.0F, {0, 0, 0}, false);
  let_decor_throw_shadows(desc, from_before());
  EXPECT_EQ(throwing(desc), std::vector{false}) << "nothing else stands";
  add_square(desc, 4.0F, {0, 0, 1}, true);
  desc.instances.back().movable = true;
  let_decor_throw_shadows(desc, from_before());
  EXPECT_EQ(throwing(desc), (std::vector{false, true})) << "what moves is elsewhere the next moment";
}

}  // namespace
}  // namespace fulcrum::scenario
