// What metal mirrors of what stands near it, against the part of its lobe that geometry says a wall fills.

#include "engine/render/mirror_volume.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/ext/matrix_transform.hpp>
#include <numbers>

#include "test_scene.h"

namespace fulcrum::render {
namespace {

constexpr float kWall = 0.25F;  // m, its height
constexpr float kRougher = 0.45F, kRough = 0.3F, kSmooth = 0.15F;

// The part of what a floor mirrors, seen at 45 degrees, that a wall of that height hides which stands that
// far before it (m): GGX over half vectors, with the masking of both directions (Walter et al., 2007).
double hidden_by_wall(double away, double roughness) {
  const double alpha = roughness * roughness, n_dot_v = std::sqrt(0.5);
  constexpr int kMany = 400;
  const auto masked = [&](double cosine) {
    return 2 * cosine / (cosine + std::sqrt(alpha * alpha + (1 - alpha * alpha) * cosine * cosine));
  };
  double all = 0, hidden = 0;
  for (int i = 0; i < kMany; ++i)
    for (int j = 0; j < kMany; ++j) {
      const double u = (i + 0.5) / kMany, turn = 2 * std::numbers::pi * (j + 0.5) / kMany;
      const double cosine = std::sqrt((1 - u) / (1 + (alpha * alpha - 1) * u)),
                   sine = std::sqrt(1 - cosine * cosine);
      // x along the wall, y up, z towards it.
      const glm::dvec3 h(sine * std::cos(turn), cosine, sine * std::sin(turn));
      const glm::dvec3 v(0, n_dot_v, -n_dot_v);
      const glm::dvec3 l = 2 * glm::dot(v, h) * h - v;
      if (l.y <= 0 || glm::dot(v, h) <= 0) continue;
      const double weight = glm::dot(v, h) * masked(n_dot_v) * masked(l.y) / (n_dot_v * cosine);
      all += weight;
      if (l.z > 0 && away * l.y / l.z < kWall) hidden += weight;
    }
  return hidden / all;
}

class MirrorVolumeTest : public testing::Test {
protected:
  void TearDown() override {
    for (const std::string& message : gpu_.instance.messages()) ADD_FAILURE() << message;
  }

  // A floor of white metal whose top is y = 0, below an even sky of 1, and before it at z = 0 the face of a
  // wall.
  static VisualDesc scene(std::optional<float> wall_colour, float roughness = kRough) {
    VisualDesc desc;
    desc.key_light.reset();
    desc.ambient.picture = Panorama{64, 32, std::vector<glm::vec3>(64 * 32, glm::vec3(1.0F)), false};
    desc.meshes = {test::make_box({0.5F, 0.02F, 0.5F}), test::make_box({0.5F, 0.5F * kWall, 0.03F})};
    desc.materials = {{"metal", glm::vec3(1.0F), 1.0F, roughness},
                      {"matt", glm::vec3(wall_colour.value_or(0.0F)), 0.0F, 1.0F}};
    desc.instances = {{0, 0, "floor", glm::translate(glm::mat4(1.0F), {0, -0.02F, 0.5F})}};
    if (wall_colour)
      desc.instances.push_back({1, 1, "wall", glm::translate(glm::mat4(1.0F), {0, 0.5F * kWall, -0.03F})});
    return desc;
  }

  std::unique_ptr<Renderer> renderer(const VisualDesc& desc, bool reflections, int shadow_size = 0) {
    auto made = Renderer::create(*gpu_.device, desc,
                                 {{24, 24}, {1, shadow_size, 1.0F, 0.0F, false, false, 0, reflections}, {}});
    if (!made) throw std::runtime_error(made.error().sentence);
    return std::move(*made);
  }

  static Picture drawn(Renderer& renderer, const glm::vec3& eye, const glm::vec3& place) {
    FrameState state;
    state.camera = {eye, place, 0.004F};
    if (const auto error = renderer.frame(state)) throw std::runtime_error(error->sentence);
    return *renderer.read_back();
  }

  static Picture drawn(Renderer& renderer, float away, float high = 1.0F) {
    const glm::vec3 place(0.0F, 0.0F, away);
    return drawn(renderer, place + high * glm::vec3(0.0F, 1.0F, 1.0F), place);
  }

  // Radiance of the floor that far before the wall, seen at 45 degrees from that high (m).
  static double radiance(Renderer& renderer, float away, float high = 1.0F) {
    return test::radiance_of(test::mean(drawn(renderer, away, high), 0.25F, 0.25F, 0.75F, 0.75F).g);
  }

  static constexpr float kPlaces[] = {0.04F, 0.08F, 0.12F, 0.16F, 0.2F, 0.24F, 0.28F,
                                      0.32F, 0.36F, 0.4F,  0.5F,  0.6F, 0.7F,  0.8F};

  test::Gpu gpu_ = test::make_gpu("llvmpipe");
};

// Smooth metal, too, whose cones are narrow: they reach the wall from far away. What the roughest of them
// mirrors beside its cone is most of what is left.
TEST_F(MirrorVolumeTest, ABlackWallHidesAsMuchOfTheSkyAsGeometrySays) {
  struct Limits {
    float roughness;
    double mean, worst, of_without;
  };
  for (const auto& [roughness, mean, most, of_without] :
       {Limits{kRougher, 0.13, 0.3, 0.4}, {kRough, 0.08, 0.2, 0.25}, {kSmooth, 0.08, 0.2, 0.25}}) {
    const auto bare = renderer(scene({}, roughness), true), walled = renderer(scene(0.0F, roughness), true),
               unmirrored = renderer(scene(0.0F, roughness), false);
    double sum = 0, worst = 0, without = 0;
    for (const float away : kPlaces) {
      const double truth = 1 - hidden_by_wall(static_cast<double>(away), static_cast<double>(roughness));
      const double all = radiance(*bare, away);
      const double error = std::abs(radiance(*walled, away) / all - truth);
      sum += error / std::size(kPlaces);
      worst = std::max(worst, error);
      without += std::abs(radiance(*unmirrored, away) / all - truth) / std::size(kPlaces);
      std::printf("roughness %.2f, %.2f m away: %.3f, by geometry %.3f\n", static_cast<double>(roughness),
                  static_cast<double>(away), radiance(*walled, away) / all, truth);
    }
    std::printf("mean %.3f, worst %.3f; by the light volume alone %.3f\n", sum, worst, without);
    EXPECT_LT(sum, mean) << roughness;
    EXPECT_LT(worst, most) << roughness;
    EXPECT_LT(sum, of_without * without) << roughness;
  }
}

// Below a thick board and a thin one, both lit from above, metal mirrors their undersides as they are seen by
// who looks up: no light from their tops, and no rings where the cone's steps meet a wall or miss it.
TEST_F(MirrorVolumeTest, NoLightIsSeenThroughABoard) {
  for (const float thick : {0.02F, 0.06F, 0.2F})  // m: 2, 7 and 25 voxels
    for (const float roughness : {0.2F, kRough, kRougher}) {
      VisualDesc desc = scene({}, roughness);
      desc.ambient.picture = Panorama{64, 32, std::vector<glm::vec3>(64 * 32, glm::vec3(0.0F)), false};
      desc.key_light.emplace();
      desc.key_light->direction = {0, -1, 0};
      desc.key_light->intensity = 1.0F;
      desc.meshes[1] = test::make_box({0.5F, 0.5F * thick, 0.5F});
      desc.materials[1].base_colour = glm::vec3(1.0F);
      desc.instances.push_back(
          {1, 1, "board", glm::translate(glm::mat4(1.0F), {0, 0.2F + 0.5F * thick, 0.5F})});
      const auto below = renderer(desc, true, 512);
      const double seen = test::radiance_of(
          test::mean(drawn(*below, {0, 0.05F, 0.5F}, {0, 0.2F, 0.5F}), 0.25F, 0.25F, 0.75F, 0.75F).g);
      double least = 1, most = 0;
      for (float away = 0.3F; away < 0.7F; away += 0.025F) {
        least = std::min(least, radiance(*below, away, 0.15F));
        most = std::max(most, radiance(*below, away, 0.15F));
      }
      std::printf("board of %.2f m, roughness %.2f: %.3f to %.3f of its top's light, %.3f seen from below\n",
                  static_cast<double>(thick), static_cast<double>(roughness), least, most, seen);
      EXPECT_LT(most, seen + 0.07) << thick << ' ' << roughness;
      EXPECT_GT(least, seen - 0.07) << thick << ' ' << roughness;
    }
}

// Walls at the grid's own border, thick and thin, before cones of every width: rough metal's are wider than
// the coarsest voxels where they meet a wall.
TEST_F(MirrorVolumeTest, InAClosedRoomNoSkyIsMirrored) {
  for (const float thick : {0.02F, 0.1F})
    for (const float roughness : {kSmooth, kRough, kRougher, 0.6F}) {
      VisualDesc desc = scene({}, roughness);
      const glm::mat4 one(1.0F);
      desc.materials[1].base_colour = glm::vec3(0.0F);
      desc.meshes = {test::make_ball(0.06F)};
      desc.instances = {{0, 0, "ball", glm::translate(one, {-0.1F, -0.1F, -0.2F})}};
      for (int axis = 0; axis < 3; ++axis)
        for (const float side : {-1.0F, 1.0F}) {
          glm::vec3 half(0.5F + thick), middle(0.0F);
          half[axis] = 0.5F * thick;
          middle[axis] = side * (0.5F + 0.5F * thick);
          desc.instances.push_back({desc.meshes.size(), 1, "wall", glm::translate(one, middle)});
          desc.meshes.push_back(test::make_box(half));
        }
      const auto room = renderer(desc, true);
      FrameState state;
      state.camera = {{0, 0, 0.45F}, {-0.1F, -0.1F, -0.2F}, 0.2F};
      ASSERT_FALSE(room->frame(state));
      const Picture seen = *room->read_back();
      double brightest = 0;
      for (std::size_t i = 1; i < seen.rgba.size(); i += 4)
        brightest = std::max(brightest, test::radiance_of(seen.rgba[i]));
      EXPECT_LT(brightest, 0.05) << thick << ' ' << roughness;
    }
}

TEST_F(MirrorVolumeTest, NothingIsMirroredWhereThereIsNothing) {
  const auto bare = renderer(scene({}), true);
  for (const float away : kPlaces) EXPECT_NEAR(radiance(*bare, away), 1.0, 0.03) << away;
}

// A white wall below an even sky is as bright as that at the most.
TEST_F(MirrorVolumeTest, NoMoreIsMirroredThanIsSent) {
  const auto walled = renderer(scene(1.0F), true);
  for (const float away : kPlaces) {
    EXPECT_LT(radiance(*walled, away), 1.03) << away;
    EXPECT_GT(radiance(*walled, away), 0.6) << away;
  }
}

TEST_F(MirrorVolumeTest, SurfacesThatAreNoMetalLookTheSame) {
  VisualDesc desc = scene(0.3F);
  desc.materials.push_back({"ball", glm::vec3(0.8F), 1.0F, kRough});  // far from what is looked at
  desc.meshes.push_back(test::make_ball(0.01F));
  desc.instances.push_back({2, 2, "ball", glm::translate(glm::mat4(1.0F), {0.4F, 0.01F, 0.1F})});
  desc.materials[0].metallic = 0.0F;
  EXPECT_EQ(drawn(*renderer(desc, true), 0.1F).rgba, drawn(*renderer(desc, false), 0.1F).rgba);
}

TEST(MirrorVolumePlan, IsBuiltForMetalAlone) {
  const auto named = [](const std::vector<BuildItem>& items, const std::string& name) {
    return std::ranges::count(items, name, &BuildItem::name);
  };
  VisualDesc desc = test::make_scene();
  for (Material& material : desc.materials) material.metallic = 1.0F, material.roughness = 0.3F;
  const auto metal = plan(desc, {});
  EXPECT_TRUE(metal->reflections);
  EXPECT_EQ(named(metal->built, "mirror volume"), 1);
  RenderOptions low;
  low.quality.reflections = false;
  EXPECT_FALSE(plan(desc, low)->reflections);
  for (Material& material : desc.materials) material.metallic = 0.0F;
  const auto matt = plan(desc, {});
  EXPECT_FALSE(matt->reflections);
  EXPECT_EQ(named(matt->built, "mirror volume"), 0);
  EXPECT_EQ(named(matt->left_out, "mirror volume"), 1);
}

}  // namespace
}  // namespace fulcrum::render
