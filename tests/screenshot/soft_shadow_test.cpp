// A light that has a size leaves penumbras as wide as geometry says, and no surface is shaded by itself.
//
// A straight edge at height h, below it a floor, above it a disc that is d across at a distance of 1 m: the
// penumbra is h d wide, and across it the visible part of a disc behind a straight edge grows.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <numbers>

#include "engine/render/frame_data.h"
#include "engine/render/levels_of_detail.h"
#include "engine/render/tone.h"
#include "test_scene.h"

namespace fulcrum::render {
namespace {

// Of a disc behind an edge that is t half widths of it off its middle.
float visible_part(float t) {
  t = std::clamp(t, -1.0F, 1.0F);
  return 0.5F + (t * std::sqrt(1.0F - t * t) + std::asin(t)) / std::numbers::pi_v<float>;
}

class SoftShadowTest : public testing::Test {
protected:
  void TearDown() override {
    for (const std::string& message : gpu_.instance.messages()) ADD_FAILURE() << message;
  }

  // A floor that throws no shadow, lit from above by nothing but a lamp.
  static VisualDesc floor(float diameter) {
    VisualDesc desc;
    desc.meshes = {test::make_box({1.0F, 0.1F, 1.0F})};
    desc.materials = {{"matt", glm::vec3(0.4F), 0.0F, 1.0F}};
    desc.instances = {{0, 0, "floor", glm::translate(glm::mat4(1.0F), {0, -0.1F, 0}), true, false}};
    desc.ambient.intensity = 0.0F;
    desc.key_light->direction = {0.0F, -1.0F, 0.0F};
    desc.key_light->colour = glm::vec3(1.0F);
    desc.key_light->intensity = 1.0F;
    desc.key_light->diameter = diameter;
    return desc;
  }

  // A board with its upper edge at x = 0 and height `height`, that covers what is left of it; seen from the
  // right, so that a picture's rows are along the edge. across: what the picture shows of x (m).
  static VisualDesc edge(float diameter, float height, float across) {
    constexpr float kThin = 0.0002F;
    VisualDesc desc = floor(diameter);
    desc.meshes.push_back(test::make_box({0.15F, kThin, 0.15F}));
    desc.instances.push_back(
        {1, 0, "board", glm::translate(glm::mat4(1.0F), {-0.15F, height - kThin, 0}), true});
    desc.camera = {{0.5F, 0.5F, 0.0F}, glm::vec3(0.0F), across};
    return desc;
  }

  // A pin on the floor, under a lamp above and to the left of it; scale: m, a hundred times the pin's height.
  static VisualDesc pin(float scale) {
    VisualDesc desc = floor(kSunDiameter * scale);
    const float s = scale;
    desc.meshes = {test::make_box({s, 0.1F * s, s}), test::make_box({0.002F * s, 0.005F * s, 0.02F * s})};
    desc.instances[0].X_WM = glm::translate(glm::mat4(1.0F), {0, -0.1F * s, 0});
    desc.instances.push_back({1, 0, "pin", glm::translate(glm::mat4(1.0F), {0, 0.005F * s, 0}), true});
    desc.key_light->kind = KeyLight::Kind::spot;
    desc.key_light->position = s * glm::vec3(-0.4F, 0.5F, 0.0F);
    desc.key_light->direction = -desc.key_light->position;
    desc.key_light->intensity = 0.4F * s * s;
    desc.camera = {s * glm::vec3(0.5F, 0.5F, 0.0F), glm::vec3(0.0F), 0.08F};
    return desc;
  }
  // How much of the light reaches the middle of the pin's shadow.
  float lit_behind_pin(const VisualDesc& desc, float scale) {
    const Picture picture = drawn(desc);
    return row_at(picture, desc.camera, {0.006F * scale, 0, 0}) /
           row_at(picture, desc.camera, {0.016F * scale, 0, 0});
  }

  Picture drawn(const VisualDesc& desc, float coarseness = 0.0F) {
    const auto renderer =
        Renderer::create(*gpu_.device, desc, {kSize, {1, 2048, 1.0F, coarseness, false, true}, {}});
    if (!renderer) throw std::runtime_error(renderer.error().sentence);
    FrameState state;
    state.camera = desc.camera;
    std::vector<glm::mat4> poses;
    for (const Instance& instance : desc.instances)
      if (instance.movable) poses.push_back(instance.X_WM);
    state.X_WM = poses;
    EXPECT_FALSE((*renderer)->frame(state));
    return *(*renderer)->read_back();
  }

  // Radiance of grey that a picture shows as that.
  static float radiance_of(float shown) {
    float low = 0.0F, high = 4.0F;
    for (int i = 0; i < 40; ++i) {
      const float middle = 0.5F * (low + high);
      (tone_mapped(glm::vec3(middle)).g < shown ? low : high) = middle;
    }
    return low;
  }

  // How dark it gets where nothing but itself could hide the light: the most of all pixels, 0..255. Drawn
  // without shadows as well.
  int most_shaded(VisualDesc desc, float coarseness = 0.0F) {
    const Picture with = drawn(desc, coarseness);
    desc.key_light->casts_shadow = false;
    const Picture without = drawn(desc, coarseness);
    int most = 0;
    for (std::size_t i = 0; i < with.rgba.size(); i += 4)
      most = std::max(most, without.rgba[i + 1] - with.rgba[i + 1]);
    return most;
  }

  // In the row of pixels that shows a place, the mean of its middle half.
  static float row_at(const Picture& picture, const Camera& camera, const glm::vec3& place) {
    const glm::vec4 clip = clip_from_world(camera, kSize) * glm::vec4(place, 1.0F);
    const float y = 0.5F - 0.5F * clip.y / clip.w, half = 0.5F / static_cast<float>(kSize.height);
    return radiance_of(test::mean(picture, 0.25F, y - half, 0.75F, y + half).g / 255.0F);
  }

  static constexpr Extent kSize{320, 240};
  test::Gpu gpu_ = test::make_gpu("llvmpipe");
};

TEST_F(SoftShadowTest, APenumbraIsAsWideAsTheDiscBehindTheEdgeMakesIt) {
  for (const float diameter : {kSunDiameter, 0.1F, 0.3F})
    for (const float height : {0.02F, 0.06F, 0.2F}) {
      const float half = 0.5F * height * diameter;
      if (half < 0.0005F) continue;  // a few texels: no edge is sharper than these
      const VisualDesc desc = edge(diameter, height, 4.0F * half);
      const Picture picture = drawn(desc);
      const float lit = row_at(picture, desc.camera, {1.6F * half, 0, 0});
      float off = 0.0F;
      for (float t = -1.5F; t < 1.55F; t += 0.1F) {
        const float wanted = visible_part(t);
        const float seen = row_at(picture, desc.camera, {t * half, 0, 0}) / lit;
        off += std::abs(seen - wanted) / 31.0F;
        EXPECT_NEAR(seen, wanted, 0.06F) << diameter << " " << height << " " << t;
      }
      EXPECT_LT(off, 0.0125F) << diameter << " " << height;
    }
}

// The same disc in a place: what is nearer to it than the floor by a third throws a wider penumbra than the
// sun.
TEST_F(SoftShadowTest, ALampNearByThrowsThePenumbraOfItsDiameter) {
  constexpr float kHeight = 0.1F, kAbove = 0.4F, kDiameter = 0.05F;
  constexpr float kHalf = 0.5F * kDiameter * kHeight / (kAbove - kHeight);
  VisualDesc desc = edge(kDiameter, kHeight, 4.0F * kHalf);
  desc.key_light->kind = KeyLight::Kind::spot;
  desc.key_light->position = {0.0F, kAbove, 0.0F};
  desc.key_light->intensity = 0.2F;
  const Picture picture = drawn(desc);
  const float lit = row_at(picture, desc.camera, {1.6F * kHalf, 0, 0});
  for (float t = -1.5F; t < 1.55F; t += 0.1F) {
    const float seen = row_at(picture, desc.camera, {t * kHalf, 0, 0}) / lit;
    EXPECT_NEAR(seen, visible_part(t), 0.06F) << t;
  }
}

TEST_F(SoftShadowTest, ASlantedBoardIsNotItsOwnShadow) {
  for (const float diameter : {kSunDiameter, 0.2F})
    for (const float degrees : {45.0F, 80.0F}) {
      VisualDesc desc = edge(diameter, 0.0F, 0.5F);
      desc.instances.erase(desc.instances.begin());
      desc.camera.target = {-0.15F, 0.0F, 0.0F};
      const float angle = degrees * std::numbers::pi_v<float> / 180.0F;
      desc.key_light->direction = {-std::sin(angle), -std::cos(angle), 0.3F * std::sin(angle)};
      EXPECT_LE(most_shaded(desc), 2) << diameter << " " << degrees;
    }
}

TEST_F(SoftShadowTest, ABallIsNotItsOwnShadowWhereTheLightDoesNotGrazeIt) {
  for (const float diameter : {kSunDiameter, 0.2F}) {
    VisualDesc desc = floor(diameter);
    desc.meshes = {test::make_ball(0.05F)};
    desc.instances = {{0, 0, "ball", glm::mat4(1.0F), true}};
    desc.camera = {{0.0F, 0.5F, 0.0F}, glm::vec3(0.0F), 0.15F};  // to 50 degrees from its middle
    EXPECT_LE(most_shaded(desc), 2) << diameter;
  }
}

// What is seen of it is coarser than what is in the map, for it is far away, where pixels are larger than
// texels.
TEST_F(SoftShadowTest, NorIsABallOfCoarserTriangles) {
  VisualDesc desc = floor(kSunDiameter);
  desc.meshes = {test::make_ball(0.05F)};
  desc.meshes[0].levels = levels_of_detail(desc.meshes[0]);
  desc.instances = {{0, 0, "ball", glm::mat4(1.0F), true}};
  desc.key_light->direction = {0.5F, -1.0F, -0.3F};
  desc.camera = {{0.0F, 3.0F, 0.0F}, glm::vec3(0.0F), 0.25F};
  EXPECT_LE(most_shaded(desc, 0.25F), 12);
}

TEST_F(SoftShadowTest, ASpotsShadowsStayWhateverIsFarFromItOrBesideIt) {
  const VisualDesc alone = pin(1.0F);
  ASSERT_LT(lit_behind_pin(alone, 1.0F), 0.2F);
  for (const glm::vec3& place :
       {glm::vec3(24.0F, -30.0F, 0.0F), {-10.0F, 20.0F, 0.0F}, {-30.0F, 0.5F, 20.0F}}) {
    VisualDesc desc = alone;
    desc.instances.push_back({1, 0, "elsewhere", glm::translate(glm::mat4(1.0F), place), true});
    EXPECT_LT(lit_behind_pin(desc, 1.0F), 0.2F) << place.x << " " << place.y;
  }
}

TEST_F(SoftShadowTest, WhereAllIsBesideItsConeASpotThrowsNoShadow) {
  VisualDesc desc = pin(1.0F);
  desc.key_light->position = {0.3F, 0.5F, 0.0F};
  desc.key_light->direction = {0.0F, -1.0F, 0.0F};
  desc.key_light->cone_rad = 0.5F;
  desc.camera.target = {0.3F, 0.0F, 0.0F};
  desc.camera.vertical_fov_rad = 0.5F;
  EXPECT_EQ(most_shaded(desc), 0);
}

TEST_F(SoftShadowTest, ASpotThrowsShadowsHoweverNearItIs) {
  for (const float scale : {0.1F, 0.01F, 0.004F}) EXPECT_LT(lit_behind_pin(pin(scale), scale), 0.2F) << scale;
}

// No light comes in below a box that stands on the floor.
TEST_F(SoftShadowTest, AtTheFootOfABoxItIsDark) {
  for (const float diameter : {kSunDiameter, 0.2F}) {
    VisualDesc desc = floor(diameter);
    desc.meshes.push_back(test::make_box({0.05F, 0.05F, 0.3F}));
    desc.instances.push_back({1, 0, "box", glm::translate(glm::mat4(1.0F), {-0.05F, 0.05F, 0}), true});
    desc.key_light->direction = {1.0F, -1.0F, 0.0F};
    desc.camera = {{0.5F, 0.3F, 0.0F}, {0.05F, 0.0F, 0.0F}, 0.4F};
    const Picture picture = drawn(desc);
    const float lit = row_at(picture, desc.camera, {0.13F, 0, 0});
    ASSERT_GT(lit, 0.1F);
    const float dark = diameter > 0.1F ? 0.06F : 0.09F;  // where its whole shadow ends
    for (float x = 0.001F; x < dark; x += 0.004F)
      EXPECT_LT(row_at(picture, desc.camera, {x, 0, 0}), 0.02F * lit) << diameter << " " << x;
  }
}

TEST_F(SoftShadowTest, ALampOfNoSizeOrALowLevelBuildsNoneOfIt) {
  VisualDesc desc = edge(0.0F, 0.1F, 0.1F);
  EXPECT_FALSE(plan(desc, {})->soft_shadows);
  desc.key_light->diameter = 0.1F;
  EXPECT_TRUE(plan(desc, {})->soft_shadows);
  RenderOptions low;
  low.quality = kQualityLevels.back();
  EXPECT_FALSE(plan(desc, low)->soft_shadows);
}

}  // namespace
}  // namespace fulcrum::render
