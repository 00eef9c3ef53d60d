// The ghost, drawn, with the validation layers watching.

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <glm/ext/matrix_transform.hpp>

#include "image_compare.h"
#include "test_scene.h"

namespace fulcrum::render {
namespace {

// The test scene with a bar instead of the ball: of a ball nobody sees how it is turned.
VisualDesc bar_scene() {
  VisualDesc desc = test::make_scene();
  desc.meshes[2] = test::make_box({0.10F, 0.012F, 0.025F});
  desc.instances[2].X_WM = glm::translate(glm::mat4(1.0F), {0.02F, 0.14F, 0.0F});
  return desc;
}

class GhostTest : public testing::Test {
protected:
  void TearDown() override {
    for (const std::string& message : gpu_.instance.messages()) ADD_FAILURE() << message;
  }

  // One frame, the ghost where the first movable instance is but turned by `angle` about `axis`.
  Picture draw(const VisualDesc& desc, float opacity, float angle = 0.44F,
               const glm::vec3& axis = {0.0F, 1.0F, 0.3F}, const Quality& quality = {4, 512, 1.0F}) {
    const auto renderer = Renderer::create(*gpu_.device, desc, {{480, 270}, quality, {}});
    if (!renderer) throw std::runtime_error(renderer.error().sentence);
    std::vector<glm::mat4> poses;
    for (const Instance& instance : desc.instances)
      if (instance.movable) poses.push_back(instance.X_WM);
    FrameState state;
    state.X_WM = poses;
    state.camera = desc.camera;
    const std::vector<GhostState> ghosts(desc.ghosts.size(),
                                         {opacity, glm::rotate(poses.at(0), angle, glm::normalize(axis))});
    state.ghosts = ghosts;
    const std::optional<Error> error = (*renderer)->frame(state);
    EXPECT_FALSE(error) << error->sentence;
    return *(*renderer)->read_back();
  }

  test::Gpu gpu_ = test::make_gpu("llvmpipe");
};

// The sum of differences in green over the part of the picture, and how many pixels differ clearly.
struct Lit {
  std::size_t pixels = 0;
  double sum = 0.0;
};

Lit lit(const Picture& with, const Picture& without) {
  Lit found;
  for (std::size_t i = 1; i < with.rgba.size(); i += 4) {
    const int difference = std::abs(int{with.rgba[i]} - int{without.rgba[i]});
    found.pixels += difference > 25 ? 1 : 0;
    found.sum += difference;
  }
  return found;
}

TEST_F(GhostTest, OfNoOpacityLeavesEveryBitAsWithoutGhost) {
  VisualDesc desc = bar_scene();
  const Picture hidden = draw(desc, 0.0F);
  const Picture shown = draw(desc, 1.0F);
  desc.ghosts.clear();
  const Picture none = draw(desc, 0.0F);
  EXPECT_TRUE(hidden.rgba == none.rgba);
  EXPECT_GT(lit(shown, none).pixels, 500U);
}

TEST_F(GhostTest, LooksAsItsGoldens) {
  const std::filesystem::path failures = FULCRUM_FAILURES;
  std::filesystem::create_directories(failures);
  for (const auto& [name, opacity] : {std::pair("ghost.png", 1.0F), std::pair("ghost_half.png", 0.5F)}) {
    const test::Comparison result =
        test::compare(draw(bar_scene(), opacity), std::filesystem::path(FULCRUM_GOLDENS) / name,
                      {.failure_folder = failures});
    EXPECT_TRUE(result.passed) << result.sentence;
  }
}

TEST_F(GhostTest, IsFainterBehindAWallAndStillThere) {
  VisualDesc desc = bar_scene();
  desc.markers.clear();
  desc.instances[1] = {0, 0, "wall", glm::mat4(1.0F), false, false};
  const auto wall_at = [&](float z) {
    VisualDesc walled = desc;
    walled.meshes[0] = test::make_box({1.0F, 1.0F, 0.01F});
    walled.instances[0].X_WM =
        glm::translate(glm::mat4(1.0F), {0.0F, 0.0F, -0.3F});  // what lies behind it all
    walled.instances[1].X_WM = glm::translate(glm::mat4(1.0F), {0.0F, 0.0F, z});
    return lit(draw(walled, 1.0F), draw(walled, 0.0F));
  };
  const Lit behind = wall_at(0.2F);
  const Lit before = wall_at(-0.2F);
  EXPECT_LT(behind.sum, 0.6 * before.sum);
  EXPECT_GT(behind.sum, 0.2 * before.sum);
}

TEST_F(GhostTest, HidesItsOwnRearLines) {
  // A small bar behind a large one, as the eye sees it: of the two together no more is drawn than of the
  // large one.
  VisualDesc large = bar_scene();
  large.meshes[2] = test::make_box({0.10F, 0.08F, 0.005F});
  large.instances[2].casts_shadow = false;  // theirs would differ
  large.camera = {{0.02F, 0.14F, 0.7F}, {0.02F, 0.14F, 0.0F}, 0.7F};
  VisualDesc both = large;
  Mesh small = test::make_box({0.05F, 0.04F, 0.005F});
  for (glm::vec3& position : small.positions) position.z -= 0.05F;
  const auto shift = static_cast<std::uint32_t>(both.meshes[2].positions.size());
  Mesh& mesh = both.meshes[2];
  mesh.positions.insert(mesh.positions.end(), small.positions.begin(), small.positions.end());
  mesh.normals.insert(mesh.normals.end(), small.normals.begin(), small.normals.end());
  for (const std::uint32_t i : small.indices) mesh.indices.push_back(shift + i);
  EXPECT_EQ(lit(draw(both, 1.0F, 0.0F), draw(large, 1.0F, 0.0F)).sum, 0.0);
  // Turned until the small one looks out from behind, it is seen.
  EXPECT_GT(lit(draw(both, 1.0F, 1.2F), draw(large, 1.0F, 1.2F)).pixels, 100U);
}

TEST_F(GhostTest, OfABallIsARing) {
  VisualDesc desc = test::make_scene();
  desc.camera.target = {0.1F, 0.12F, 0.0F};  // the ball in the middle
  desc.camera.eye = {0.1F, 0.12F, 0.5F};
  const Picture with = draw(desc, 1.0F);
  const Picture without = draw(desc, 0.0F);
  // Radius of the outline: r / sqrt(d^2 - r^2) over tan(fov / 2), of half the height.
  const float radius = 135.0F * (0.05F / std::sqrt(0.25F - 0.0025F)) / std::tan(0.35F);
  std::size_t on = 0;
  for (std::size_t y = 0; y < with.height; ++y) {
    for (std::size_t x = 0; x < with.width; ++x) {
      const std::size_t i = (y * with.width + x) * 4;
      if (with.rgba[i] == without.rgba[i] && with.rgba[i + 1] == without.rgba[i + 1]) continue;
      const float from_middle =
          std::hypot(static_cast<float>(x) + 0.5F - 240.0F, static_cast<float>(y) + 0.5F - 135.0F);
      EXPECT_NEAR(from_middle, radius, 5.0F);
      ++on;
    }
  }
  EXPECT_GT(on, static_cast<std::size_t>(2.0F * 3.14F * radius));  // all around, a pixel wide at least
}

TEST_F(GhostTest, IsDrawnTheSameAtEveryQuality) {
  const VisualDesc desc = bar_scene();
  const auto drawn_at = [&](const Quality& quality) {
    return static_cast<double>(
        lit(draw(desc, 1.0F, 0.44F, {0, 1, 0.3F}, quality), draw(desc, 0.0F, 0.44F, {0, 1, 0.3F}, quality))
            .pixels);
  };
  const double best = drawn_at({4, 512, 1.0F});
  for (const Quality& quality :
       {Quality{1, 512, 1.0F}, Quality{1, 512, 0.75F}, Quality{1, 0, 0.5F}, Quality{4, 0, 0.37F}})
    EXPECT_NEAR(drawn_at(quality), best, 0.06 * best) << quality.samples << ", " << quality.resolution_scale;
}

TEST_F(GhostTest, RunsOutOfThePictureWhereItPassesTheEye) {
  VisualDesc desc = bar_scene();
  // 8 mm above an edge of the bar, which is turned to run from behind the eye to before it.
  desc.camera.eye = {0.045F, 0.16F, 0.0F};
  desc.camera.target = {0.045F, 0.15F, -0.3F};
  const Picture with = draw(desc, 1.0F, 1.5708F, {0, 1, 0});
  const Picture without = draw(desc, 0.0F, 1.5708F, {0, 1, 0});
  const auto differs_in_rows = [&](std::size_t from, std::size_t to) {
    const std::size_t row = std::size_t{4} * with.width;
    return !std::equal(with.rgba.begin() + static_cast<std::ptrdiff_t>(from * row),
                       with.rgba.begin() + static_cast<std::ptrdiff_t>(to * row),
                       without.rgba.begin() + static_cast<std::ptrdiff_t>(from * row));
  };
  EXPECT_FALSE(differs_in_rows(0, 135));  // it lies below the eye: nothing above the middle
  EXPECT_TRUE(differs_in_rows(260, 270));
  desc.camera.target = {0.02F, 0.9F, 0.0F};  // away from it
  EXPECT_TRUE(draw(desc, 1.0F).rgba == draw(desc, 0.0F).rgba);
}

// Each in its own place and colour, with the lines of both: neither hides the other's.
TEST_F(GhostTest, TwoAreBothDrawn) {
  VisualDesc desc = bar_scene();
  desc.ghosts = {Ghost{.colour = {1.0F, 0.0F, 0.0F}}, Ghost{.colour = {0.0F, 0.0F, 1.0F}}};
  const auto renderer = Renderer::create(*gpu_.device, desc, {{480, 270}, {4, 512, 1.0F}, {}});
  ASSERT_TRUE(renderer);
  const auto drawn = [&](float first, float second) {
    const GhostState ghosts[] = {{first, glm::translate(desc.instances[2].X_WM, {-0.04F, 0.03F, 0.0F})},
                                 {second, glm::translate(desc.instances[2].X_WM, {0.04F, -0.02F, 0.0F})}};
    FrameState state;
    state.X_WM = {&desc.instances[2].X_WM, 1};
    state.camera = desc.camera;
    state.ghosts = ghosts;
    const std::optional<Error> error = (*renderer)->frame(state);
    EXPECT_FALSE(error) << error->sentence;
    return *(*renderer)->read_back();
  };
  const Picture none = drawn(0, 0), first = drawn(1, 0), second = drawn(0, 1), both = drawn(1, 1);
  std::size_t of_first = 0, of_second = 0;
  for (std::size_t i = 0; i < none.rgba.size(); i += 4) {
    const auto differs = [&](const Picture& from) {
      return !std::equal(none.rgba.begin() + static_cast<std::ptrdiff_t>(i),
                         none.rgba.begin() + static_cast<std::ptrdiff_t>(i + 3),
                         from.rgba.begin() + static_cast<std::ptrdiff_t>(i));
    };
    const bool in_first = differs(first), in_second = differs(second);
    if (in_first && in_second) continue;
    const Picture& alone = in_first ? first : in_second ? second : none;
    for (std::size_t c = 0; c < 3; ++c)  // where a halo ends, less than a step of the other's is left
      ASSERT_NEAR(both.rgba[i + c], alone.rgba[i + c], 2) << i;
    of_first += in_first && first.rgba[i] > first.rgba[i + 2] + 25 ? 1 : 0;
    of_second += in_second && second.rgba[i + 2] > second.rgba[i] + 25 ? 1 : 0;
  }
  EXPECT_GT(of_first, 200U);
  EXPECT_GT(of_second, 200U);
}

TEST_F(GhostTest, WhereTheSceneHasNoneIsRefused) {
  VisualDesc desc = bar_scene();
  desc.ghosts.clear();
  const auto renderer = Renderer::create(*gpu_.device, desc, {{64, 64}, {1, 0, 1.0F}, {}});
  ASSERT_TRUE(renderer);
  FrameState state;
  state.X_WM = {&desc.instances[2].X_WM, 1};
  const GhostState ghost{.opacity = 1.0F};
  state.ghosts = {&ghost, 1};
  const std::optional<Error> error = (*renderer)->frame(state);
  ASSERT_TRUE(error);
  EXPECT_NE(error->sentence.find("ghost"), std::string::npos);
}

}  // namespace
}  // namespace fulcrum::render
