// Pictures for two eyes: where a known point is in each of them, how they are put together, what is built.

#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <functional>
#include <glm/ext/matrix_transform.hpp>

#include "image_compare.h"
#include "test_scene.h"

namespace fulcrum::render {
namespace {

constexpr StereoMode kAllModes[] = {StereoMode::side_by_side, StereoMode::top_bottom, StereoMode::interlaced,
                                    StereoMode::anaglyph};

std::string name_of(StereoMode mode) {
  return std::string(kStereoModeNames[static_cast<std::size_t>(mode)]);
}

// Of one eye's pixels in a picture of that mode: how bright, and where in its own picture.
struct Spot {
  double bright = 0;
  glm::dvec2 at{};  // px
};

Spot spot(const Picture& picture, StereoMode mode, Eye eye, std::uint32_t x, std::uint32_t y) {
  const std::uint8_t* rgba = &picture.rgba[4 * (std::size_t{y} * picture.width + x)];
  const double bright = (rgba[0] + rgba[1] + rgba[2]) / 3.0;
  const bool right = eye == Eye::right;
  glm::dvec2 at(x + 0.5, y + 0.5);
  bool is_mine = true;
  switch (mode) {
    case StereoMode::side_by_side:
      is_mine = (x >= picture.width / 2) == right;
      at.x = 2.0 * (at.x - (right ? picture.width / 2 : 0));
      break;
    case StereoMode::top_bottom:
      is_mine = (y >= picture.height / 2) == right;
      at.y = 2.0 * (at.y - (right ? picture.height / 2 : 0));
      break;
    case StereoMode::interlaced:
      is_mine = (y % 2 == 1) == right;
      break;
    case StereoMode::anaglyph:
      return {right ? 0.5 * (rgba[1] + rgba[2]) : 1.0 * rgba[0], at};
  }
  return {is_mine ? bright : 0.0, at};
}

// px, of what is bright in that eye's picture.
glm::dvec2 centroid(const Picture& picture, StereoMode mode, Eye eye) {
  glm::dvec2 sum{};
  double all = 0;
  for (std::uint32_t y = 0; y < picture.height; ++y)
    for (std::uint32_t x = 0; x < picture.width; ++x) {
      const Spot one = spot(picture, mode, eye, x, y);
      if (one.bright < 8) continue;  // the background
      sum += one.bright * one.at;
      all += one.bright;
    }
  EXPECT_GT(all, 0) << "nothing is seen of it";
  return sum / all;
}

// A small white ball before black.
VisualDesc ball_at(const glm::vec3& p_W) {
  VisualDesc desc;
  desc.meshes = {test::make_ball(0.008F)};
  desc.materials = {{"white", glm::vec3(0.9F), 0.0F, 1.0F}};
  desc.instances = {{0, 0, "ball", glm::translate(glm::mat4(1.0F), p_W), false, false}};
  desc.key_light.reset();
  desc.ambient = {glm::vec3(3.0F), glm::vec3(3.0F), 1.0F, false};
  desc.background = {glm::vec3(0.0F), glm::vec3(0.0F)};
  desc.camera = {{0, 0, 0.5F}, {0, 0, 0}, 0.7F, 1, {0.02F, 0.4F}};
  return desc;
}

class StereoTest : public testing::Test {
protected:
  void TearDown() override {
    for (const std::string& message : gpu_.instance.messages()) ADD_FAILURE() << message;
  }

  std::unique_ptr<Renderer> make(const VisualDesc& desc, std::optional<StereoMode> mode, Extent extent,
                                 const Quality& quality = {4, 512, 1.0F}) {
    RenderOptions options{extent, quality, {}, {}};
    if (mode) options.stereo = Stereo{*mode};
    auto made = Renderer::create(*gpu_.device, desc, options);
    if (!made) throw std::runtime_error(made.error().sentence);
    return std::move(*made);
  }

  // The test scene with its ghost beside the ball, or a scene without anything that moves.
  FrameState state(const VisualDesc& desc) {
    FrameState state;
    state.camera = desc.camera;
    poses_.clear();
    for (const Instance& instance : desc.instances)
      if (instance.movable) poses_.push_back(instance.X_WM);
    state.X_WM = poses_;
    if (!desc.markers.empty()) state.markers = markers_;
    if (!desc.ghosts.empty()) {
      ghost_ = {1.0F, glm::translate(poses_[0], {0.05F, 0.03F, 0.05F})};
      state.ghosts = {&ghost_, 1};
    }
    return state;
  }

  static Picture drawn(Renderer& renderer, const FrameState& state) {
    const std::optional<Error> error = renderer.frame(state);
    EXPECT_FALSE(error) << error->sentence;
    return *renderer.read_back();
  }

  test::Gpu gpu_ = test::make_gpu("llvmpipe");
  std::vector<glm::mat4> poses_;
  GhostState ghost_;
  std::vector<MarkerState> markers_ = {{MarkerState::Show::next, 1.0F}};
};

TEST_F(StereoTest, DisparityIsThatOfTheoryInEveryMode) {
  constexpr Extent extent{640, 360};
  const double focal = 180.0 / std::tan(0.35);  // px
  for (const StereoMode mode : kAllModes)
    for (const float z : {0.2F, 0.4F, 0.9F}) {
      const VisualDesc desc = ball_at({0.01F, 0.005F, 0.5F - z});
      const auto renderer = make(desc, mode, extent, {4, 0, 1.0F});
      const Picture picture = drawn(*renderer, state(desc));
      const glm::dvec2 apart = centroid(picture, mode, Eye::right) - centroid(picture, mode, Eye::left);
      const double expected = focal * 0.02 * (1.0 / 0.4 - 1.0 / static_cast<double>(z));
      EXPECT_NEAR(apart.x, expected, 0.5) << name_of(mode) << ", " << z << " m";
      EXPECT_NEAR(apart.y, 0.0, 0.5) << name_of(mode) << ", " << z << " m";
      RecordProperty(name_of(mode) + "_" + std::to_string(z), std::to_string(apart.x - expected));
    }
}

// Eyes without a distance see what one eye sees: each row of the interlaced picture is the mono one's, and
// the halves of a squeezed one are alike.
TEST_F(StereoTest, WithoutADistanceThePicturesAreTheMonoOne) {
  VisualDesc desc = test::make_scene();
  desc.camera.eyes.distance = 0.0F;
  constexpr Extent extent{320, 180};
  const FrameState frame = state(desc);
  const Picture mono = drawn(*make(desc, {}, extent), frame);
  EXPECT_TRUE(drawn(*make(desc, StereoMode::interlaced, extent), frame).rgba == mono.rgba);
  for (const auto& [mode, half] : {std::pair(StereoMode::side_by_side, std::size_t{160} * 4),
                                   std::pair(StereoMode::top_bottom, std::size_t{90} * 320 * 4)}) {
    const Picture picture = drawn(*make(desc, mode, extent), frame);
    std::size_t differing = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 2 * half)
      for (std::size_t k = 0; k < half; ++k)
        differing += picture.rgba[i + k] == picture.rgba[i + half + k] ? 0 : 1;
    EXPECT_EQ(differing, 0U) << name_of(mode);
    const glm::vec3 left = test::mean(picture, 0.0F, 0.0F, mode == StereoMode::side_by_side ? 0.5F : 1.0F,
                                      mode == StereoMode::side_by_side ? 1.0F : 0.5F);
    const glm::vec3 whole = test::mean(mono, 0.0F, 0.0F, 1.0F, 1.0F);
    EXPECT_NEAR(glm::distance(left, whole), 0.0F, 0.5F) << "the whole picture, squeezed";
  }
}

TEST_F(StereoTest, RowsAlternateAndTheEvenOnesAreTheLeftEyes) {
  const VisualDesc desc = test::make_scene();
  constexpr Extent extent{320, 180};
  const FrameState both = state(desc);
  const Picture picture = drawn(*make(desc, StereoMode::interlaced, extent), both);
  const auto mono = make(desc, {}, extent);
  for (const Eye eye : {Eye::left, Eye::right}) {
    FrameState alone = both;
    alone.camera = seen_by(eye, {}, desc.camera);
    const Picture expected = drawn(*mono, alone);
    int most = 0;
    for (std::size_t y = eye == Eye::right ? 1 : 0; y < 180; y += 2)
      for (std::size_t i = y * 1280; i < (y + 1) * 1280; ++i)
        most = std::max(most, std::abs(int{picture.rgba[i]} - int{expected.rgba[i]}));
    EXPECT_EQ(most, 0) << "markers, ghost and shadows are there, too";
  }
}

TEST_F(StereoTest, AnaglyphKeepsGreyAndGivesEitherEyeItsOwn) {
  VisualDesc desc = ball_at({0, 0, 0});
  desc.camera.eyes.distance = 0.0F;
  constexpr Extent extent{320, 180};
  const FrameState frame = state(desc);
  const Picture grey = drawn(*make(desc, StereoMode::anaglyph, extent), frame);
  const Picture mono = drawn(*make(desc, {}, extent), frame);
  int most = 0;
  for (std::size_t i = 0; i < grey.rgba.size(); ++i)
    most = std::max(most, std::abs(int{grey.rgba[i]} - int{mono.rgba[i]}));
  EXPECT_LE(most, 3);
  desc.camera.eyes.distance = 0.1F;  // the ball is twice in the picture, apart
  const Picture apart = drawn(*make(desc, StereoMode::anaglyph, extent), state(desc));
  int both = 0, red = 0, cyan = 0;
  for (std::size_t i = 0; i < apart.rgba.size(); i += 4) {
    const bool is_red = apart.rgba[i] > 60, is_cyan = apart.rgba[i + 1] > 60 && apart.rgba[i + 2] > 60;
    red += is_red ? 1 : 0;
    cyan += is_cyan ? 1 : 0;
    both += is_red && is_cyan ? 1 : 0;
  }
  EXPECT_GT(red, 50);
  EXPECT_NEAR(red, cyan, 8);
  EXPECT_EQ(both, 0) << "nothing of one eye's is left for the other";
}

TEST_F(StereoTest, LooksAsItsGoldens) {
  const std::filesystem::path failures = FULCRUM_FAILURES;
  std::filesystem::create_directories(failures);
  const VisualDesc desc = test::make_scene();
  for (const StereoMode mode : kAllModes) {
    const Picture picture = drawn(*make(desc, mode, {320, 180}), state(desc));
    const test::Comparison result =
        test::compare(picture, std::filesystem::path(FULCRUM_GOLDENS) / ("stereo_" + name_of(mode) + ".png"),
                      {.failure_folder = failures});
    EXPECT_TRUE(result.passed) << result.sentence;
  }
}

TEST_F(StereoTest, IsBuiltWhereItIsAskedForAndNowhereElse) {
  const VisualDesc desc = test::make_scene();
  const auto names = [](const std::vector<BuildItem>& items) {
    std::string all;
    for (const BuildItem& item : items) all += item.name + ", ";
    return all;
  };
  RenderOptions options;
  const Result<RenderPlan> mono = plan(desc, options);
  ASSERT_TRUE(mono);
  for (const char* name : {"second eye", "eyes, ", "screen layer, ", "stereo"})
    EXPECT_EQ(names(mono->built).find(name), std::string::npos) << name;
  EXPECT_NE(names(mono->left_out).find("stereo, stereo"), std::string::npos);
  options.stereo = Stereo{StereoMode::side_by_side};
  const Result<RenderPlan> both = plan(desc, options);
  ASSERT_TRUE(both);
  EXPECT_EQ(both->eye, (Extent{640, 720}));
  EXPECT_EQ(both->scene, (Extent{640, 720}));
  for (const char* name : {"second eye", "eyes, ", "screen layer, ", "stereo"})
    EXPECT_NE(names(both->built).find(name), std::string::npos) << name;
  EXPECT_EQ(names(both->left_out).find("stereo"), std::string::npos);
}

// A headset's, and one without panels.
TEST_F(StereoTest, WhereNothingCanLieAtTheScreenThePictureIsTheSame) {
  const VisualDesc desc = test::make_scene();
  for (const StereoMode mode : {StereoMode::side_by_side, StereoMode::interlaced, StereoMode::anaglyph}) {
    RenderOptions options{{320, 180}, {4, 512, 1.0F}, {}, {}};
    options.stereo = Stereo{mode};
    options.at_screen = false;
    const auto bare = Renderer::create(*gpu_.device, desc, options);
    ASSERT_TRUE(bare) << bare.error().sentence;
    EXPECT_TRUE(drawn(**bare, state(desc)).rgba == drawn(*make(desc, mode, {320, 180}), state(desc)).rgba)
        << name_of(mode);
  }
}

TEST_F(StereoTest, AScreenWithoutHeightIsRefused) {
  RenderOptions options;
  options.stereo = Stereo{StereoMode::anaglyph, Screen{}};
  const Result<RenderPlan> refused = plan(test::make_scene(), options);
  ASSERT_FALSE(refused);
  EXPECT_NE(refused.error().sentence.find("height"), std::string::npos);
}

TEST_F(StereoTest, FollowsOtherSizesQualitiesAndASecondView) {
  const VisualDesc desc = test::make_scene();
  for (const StereoMode mode : kAllModes) {
    const auto renderer = make(desc, mode, {320, 180});
    FrameState frame = state(desc);
    const Picture first = drawn(*renderer, frame);
    frame.inset = {{{0.7F, 0.2F, 0.0F}, {0.0F, 0.08F, 0.0F}, 0.6F}, 200, 100, 96, 60};
    const Picture with_inset = drawn(*renderer, frame);
    EXPECT_FALSE(with_inset.rgba == first.rgba);
    for (const Extent size : {Extent{321, 181}, Extent{1, 1}, Extent{17, 640}}) {
      frame.inset.reset();
      ASSERT_FALSE(renderer->resize(size));
      EXPECT_EQ(drawn(*renderer, frame).width, size.width);
    }
    ASSERT_FALSE(renderer->set_quality({1, 0, 0.5F}));
    drawn(*renderer, frame);
    ASSERT_FALSE(renderer->resize({320, 180}));
    ASSERT_FALSE(renderer->set_quality({4, 512, 1.0F}));
    EXPECT_TRUE(drawn(*renderer, frame).rgba == first.rgba) << name_of(mode);
  }
}

}  // namespace
}  // namespace fulcrum::render
