// Drawing, with the validation layers watching: every test ends with their silence.

#include "engine/render/renderer.h"

#include <gtest/gtest.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <fstream>
#include <glm/ext/matrix_transform.hpp>
#include <utility>

#include "image_compare.h"
#include "test_scene.h"

namespace fulcrum::render {
namespace {

class RendererTest : public testing::Test {
protected:
  void TearDown() override {
    for (const std::string& message : gpu_.instance.messages()) ADD_FAILURE() << message;
  }

  std::unique_ptr<Renderer> make(const VisualDesc& desc, const RenderOptions& options) {
    auto made = Renderer::create(*gpu_.device, desc, options);
    if (!made) throw std::runtime_error(made.error().sentence);
    return std::move(*made);
  }

  // One frame of the scene as described, its markers in `states`.
  Picture draw(Renderer& renderer, const VisualDesc& desc, std::span<const MarkerState> states = {}) {
    std::vector<glm::mat4> poses;
    for (const Instance& instance : desc.instances)
      if (instance.movable) poses.push_back(instance.X_WM);
    FrameState state;
    state.X_WM = poses;
    state.markers = states;
    state.camera = desc.camera;
    const std::optional<Error> error = renderer.frame(state);
    EXPECT_FALSE(error) << error->sentence;
    return *renderer.read_back();
  }

  test::Gpu gpu_ = test::make_gpu();
  RenderOptions small_{{320, 180}, {4, 512, 1.0F}, {}};
};

TEST_F(RendererTest, TwoRenderersDrawTheSamePicture) {
  const VisualDesc desc = test::make_scene();
  const Picture first = draw(*make(desc, small_), desc);
  const Picture second = draw(*make(desc, small_), desc);
  const test::Comparison result =
      test::compare(first, second, {.max_lsb = 0, .max_pixels = 0, .failure_folder = {}});
  EXPECT_TRUE(result.passed) << result.sentence;
}

TEST_F(RendererTest, TheBoxIsRedAndStandsAtTheLeft) {
  const VisualDesc desc = test::make_scene();
  const Picture picture = draw(*make(desc, small_), desc);
  const glm::vec3 box = test::mean(picture, 0.33F, 0.55F, 0.40F, 0.65F);
  EXPECT_GT(box.r, 2.0F * box.g);
}

// There the half vector is the view itself, and its product with it rounds to more than 1.
TEST_F(RendererTest, SeenAlongTheLightNoPixelIsBlack) {
  VisualDesc desc = test::make_scene();
  desc.instances.resize(1);  // the floor
  desc.ghosts.clear();
  desc.markers.clear();
  for (const glm::vec3& direction : {glm::vec3(-0.75F, -0.7F, -0.4F), glm::vec3(0.3F, -1.0F, 0.2F)}) {
    desc.key_light->direction = direction;
    desc.camera = {-0.5F * direction, glm::vec3(0.0F), 0.02F};
    const Picture picture = draw(*make(desc, small_), desc);
    int black = 0;
    for (std::size_t i = 0; i < picture.rgba.size(); i += 4) black += picture.rgba[i] < 20 ? 1 : 0;
    EXPECT_EQ(black, 0);
  }
}

TEST_F(RendererTest, TheBallThrowsAShadowThatMovesWithIt) {
  VisualDesc desc = test::make_scene();
  const std::unique_ptr<Renderer> renderer = make(desc, small_);
  const auto under = [](const Picture& p) { return test::mean(p, 0.63F, 0.56F, 0.67F, 0.60F).g; };
  const float shadowed = under(draw(*renderer, desc));
  desc.instances[2].X_WM = glm::translate(glm::mat4(1.0F), {0.3F, 0.3F, -0.4F});
  const float lit = under(draw(*renderer, desc));
  EXPECT_GT(lit, shadowed + 25.0F);
}

// A renderer that has drawn the ball elsewhere, and keeps what the others throw, draws what a new one does:
// between two boxes far apart the map is the same wherever the ball is.
TEST_F(RendererTest, ShadowsOfWhatStandsAreKeptWhileTheBallMoves) {
  VisualDesc desc = test::make_scene();
  for (const glm::vec3& corner : {glm::vec3(-0.3F, 0.3F, -0.3F), {0.3F, 0.0F, 0.3F}})
    desc.instances.push_back({1, 1, "corner", glm::translate(glm::mat4(1.0F), corner), false, true});
  const std::unique_ptr<Renderer> renderer = make(desc, small_);
  EXPECT_TRUE(renderer->plan().standing_shadows);
  draw(*renderer, desc);
  // Last far away, where the map has to grow.
  for (const glm::vec3& place : {glm::vec3(0.02F, 0.10F, 0.01F), {-0.1F, 0.2F, 0.0F}, {0.9F, 0.1F, -0.9F}}) {
    desc.instances[2].X_WM = glm::translate(glm::mat4(1.0F), place);
    const test::Comparison same = test::compare(draw(*renderer, desc), draw(*make(desc, small_), desc),
                                                {.max_lsb = 0, .max_pixels = 0, .failure_folder = {}});
    EXPECT_TRUE(same.passed) << same.sentence;
  }
}

// The ball is drawn where it is told to be last, and so is its shadow in the frame after.
TEST_F(RendererTest, ABallThatIsPlacedLateIsDrawnThere) {
  VisualDesc desc = test::make_scene();
  desc.ghosts.clear();
  const glm::mat4 early = desc.instances[2].X_WM;
  const glm::mat4 newest = glm::translate(glm::mat4(1.0F), {-0.02F, 0.12F, 0.03F});
  FrameState state;
  state.X_WM = {&early, 1};
  state.camera = desc.camera;
  const test::CompareOptions exact{.max_lsb = 0, .max_pixels = 0, .failure_folder = {}};
  for (const int shadow : {0, 512}) {
    RenderOptions options = small_;
    options.quality.shadow_size = shadow;
    desc.instances[2].X_WM = newest;
    const Picture wanted = draw(*make(desc, options), desc);
    desc.instances[2].X_WM = early;
    const std::unique_ptr<Renderer> renderer = make(desc, options);
    const Picture before = draw(*renderer, desc);
    int asked = 0;
    const auto late = [&] {
      ++asked;
      return std::span(&newest, 1);
    };
    ASSERT_FALSE(renderer->frame(state, {}, late));
    EXPECT_EQ(asked, 1);
    const Picture placed = *renderer->read_back();
    EXPECT_FALSE(test::compare(placed, before, exact).passed);
    if (shadow == 0) EXPECT_TRUE(test::compare(placed, wanted, exact).passed);
    desc.instances[2].X_WM = newest;
    EXPECT_TRUE(test::compare(draw(*renderer, desc), wanted, exact).passed);
  }
}

TEST_F(RendererTest, PosesThatAreToldLateHaveToBeAsMany) {
  const VisualDesc desc = test::make_scene();
  const std::unique_ptr<Renderer> renderer = make(desc, small_);
  draw(*renderer, desc);
  FrameState state;
  state.X_WM = {&desc.instances[2].X_WM, 1};
  state.camera = desc.camera;
  const std::vector<glm::mat4> two(2, glm::mat4(1.0F));
  const std::optional<Error> error = renderer->frame(state, {}, [&] { return std::span(two); });
  ASSERT_TRUE(error);
  EXPECT_NE(error->sentence.find("told 2 poses late, but the scene has 1"), std::string::npos)
      << error->sentence;
  draw(*renderer, desc);
}

TEST_F(RendererTest, WhatOnlyStandsOrOnlyMovesNeedsNoSecondShadowMap) {
  VisualDesc desc = test::make_scene();
  desc.ghosts.clear();
  desc.instances[2].movable = false;
  EXPECT_FALSE(make(desc, small_)->plan().standing_shadows);
  desc.instances[2].movable = true;
  EXPECT_TRUE(make(desc, small_)->plan().standing_shadows);
  desc.instances.erase(desc.instances.begin() + 1);  // the floor throws none
  EXPECT_FALSE(make(desc, small_)->plan().standing_shadows);
}

TEST_F(RendererTest, AShadowMapThatIsKeptDrawsTheSamePicture) {
  const VisualDesc desc = test::make_scene();
  const std::unique_ptr<Renderer> renderer = make(desc, small_);
  const Picture drawn = draw(*renderer, desc);
  const Picture kept = draw(*renderer, desc);
  EXPECT_TRUE(test::compare(drawn, kept, {.max_lsb = 0, .max_pixels = 0, .failure_folder = {}}).passed);
}

TEST_F(RendererTest, AMarkerGlowsInTheColourOfItsState) {
  using Show = MarkerState::Show;
  const VisualDesc desc = test::make_scene();
  const std::unique_ptr<Renderer> renderer = make(desc, small_);
  const auto at_marker = [&](MarkerState state) {
    return test::mean(draw(*renderer, desc, {&state, 1}), 0.36F, 0.17F, 0.38F, 0.22F);
  };
  const glm::vec3 hidden = at_marker({Show::hidden, 0.0F});
  const glm::vec3 next = at_marker({Show::next, 0.0F}) - hidden;
  const glm::vec3 dwelling = at_marker({Show::dwelling, 0.5F}) - hidden;
  const glm::vec3 done = at_marker({Show::done, 1.0F}) - hidden;
  EXPECT_GT(next.b, next.r + 20.0F);
  EXPECT_GT(dwelling.r, dwelling.b + 20.0F);
  EXPECT_GT(done.g, done.r + 10.0F);
}

TEST_F(RendererTest, LessIsBuiltForLessAndStillDrawn) {
  VisualDesc desc = test::make_scene();
  desc.markers.clear();
  desc.key_light.reset();
  const std::unique_ptr<Renderer> dim = make(desc, small_);
  EXPECT_FALSE(dim->plan().markers);
  EXPECT_EQ(dim->plan().shadow_size, 0);
  const Picture picture = draw(*dim, desc);
  EXPECT_GT(test::mean(picture, 0.0F, 0.0F, 1.0F, 1.0F).g, 10.0F);
  const VisualDesc nothing;
  draw(*make(nothing, small_), nothing);
}

TEST_F(RendererTest, ASpotLightsItsConeOnly) {
  VisualDesc desc = test::make_scene();
  desc.key_light->kind = KeyLight::Kind::spot;
  desc.key_light->position = {0.0F, 1.0F, 0.0F};
  desc.key_light->cone_rad = 0.5F;
  desc.key_light->intensity = 6.0F;
  const Picture picture = draw(*make(desc, small_), desc);
  const float inside = test::mean(picture, 0.48F, 0.65F, 0.52F, 0.70F).g;
  const float outside = test::mean(picture, 0.02F, 0.90F, 0.10F, 0.98F).g;
  EXPECT_GT(inside, outside + 30.0F);
}

// What a camera does not see throws no shadow either: the picture is that of a scene without it.
TEST_F(RendererTest, ACameraSeesItsLayersOnly) {
  VisualDesc desc = test::make_scene();
  desc.ghosts.clear();  // it is a copy of what is taken away here
  VisualDesc without = desc;
  std::erase_if(without.instances, [](const Instance& instance) { return instance.movable; });
  for (Instance& instance : desc.instances) instance.layers = instance.movable ? 2 : 3;
  desc.camera.layers = 2;
  const std::unique_ptr<Renderer> renderer = make(desc, small_);
  const Picture whole = draw(*renderer, desc);
  desc.camera.layers = 1;
  const Picture hidden = draw(*renderer, desc);
  const Picture wanted = draw(*make(without, small_), without);
  const test::CompareOptions exact{.max_lsb = 0, .max_pixels = 0, .failure_folder = {}};
  EXPECT_FALSE(test::compare(whole, wanted, exact).passed);
  EXPECT_TRUE(test::compare(hidden, wanted, exact).passed);
  desc.camera.layers = 2;
  EXPECT_TRUE(test::compare(draw(*renderer, desc), whole, exact).passed);
}

TEST_F(RendererTest, WhatACameraDoesNotSeeHidesNoLightFromIt) {
  VisualDesc desc = test::make_scene();
  desc.ghosts.clear();
  VisualDesc without = desc;
  without.instances.erase(without.instances.begin() + 1);  // the box, which stands
  for (Instance& instance : desc.instances) instance.layers = 3;
  desc.instances[1].layers = 2;
  desc.camera.layers = 1;
  const std::unique_ptr<Renderer> renderer = make(desc, small_);
  const Picture seen = draw(*renderer, desc);
  const Picture wanted = draw(*make(without, small_), without);
  const test::CompareOptions exact{.max_lsb = 0, .max_pixels = 0, .failure_folder = {}};
  EXPECT_TRUE(test::compare(seen, wanted, exact).passed);
  desc.camera.layers = 2;
  const Picture with_the_box = draw(*renderer, desc);
  EXPECT_FALSE(test::compare(with_the_box, wanted, exact).passed);
  desc.camera.layers = 1;
  EXPECT_TRUE(test::compare(draw(*renderer, desc), seen, exact).passed);
}

TEST_F(RendererTest, OneMeshIsOnTheSameLayersEverywhere) {
  VisualDesc desc = test::make_scene();
  desc.instances.push_back(desc.instances.front());
  desc.instances.back().layers = 2;
  const auto made = Renderer::create(*gpu_.device, desc, small_);
  ASSERT_FALSE(made);
  EXPECT_NE(made.error().sentence.find("is on other layers than instance 0"), std::string::npos)
      << made.error().sentence;
}

TEST_F(RendererTest, ResizesAndChangesQualityInPlace) {
  const VisualDesc desc = test::make_scene();
  const std::unique_ptr<Renderer> renderer = make(desc, small_);
  draw(*renderer, desc);
  ASSERT_FALSE(renderer->resize({200, 100}));
  EXPECT_FALSE(renderer->read_back());  // nothing is drawn yet at this size
  EXPECT_EQ(draw(*renderer, desc).width, 200U);
  ASSERT_FALSE(renderer->set_quality({1, 0, 0.5F}));
  EXPECT_EQ(draw(*renderer, desc).height, 100U);
  EXPECT_EQ(renderer->plan().scene, (Extent{100, 50}));
  ASSERT_FALSE(renderer->set_quality({4, 256, 1.0F}));
  draw(*renderer, desc);
  EXPECT_TRUE(renderer->set_quality({3, 256, 1.0F}));
  EXPECT_EQ(renderer->quality().samples, 4);
}

// Sanitizers take all the room for addresses that there is.
#if defined(__has_feature)
#if __has_feature(address_sanitizer) || __has_feature(thread_sanitizer)
constexpr bool kRoomCanBeLimited = false;
#else
constexpr bool kRoomCanBeLimited = true;
#endif
#else
constexpr bool kRoomCanBeLimited = true;
#endif

// While it lives, this process gets no more than so much memory (bytes) beside what it has.
class LimitedRoom {
public:
  explicit LimitedRoom(std::size_t more) {
    getrlimit(RLIMIT_AS, &before_);
    std::size_t pages = 0;
    std::ifstream("/proc/self/statm") >> pages;
    const rlimit now{pages * static_cast<std::size_t>(sysconf(_SC_PAGESIZE)) + more, before_.rlim_max};
    setrlimit(RLIMIT_AS, &now);
  }
  ~LimitedRoom() { setrlimit(RLIMIT_AS, &before_); }
  LimitedRoom(const LimitedRoom&) = delete;
  LimitedRoom& operator=(const LimitedRoom&) = delete;

private:
  rlimit before_{};
};

// A driver without a graphics card draws in this process's memory. Two levels need more of it than there is.
TEST_F(RendererTest, WhereMemoryIsShortForALevelTheNextIsDrawn) {
  if (!kRoomCanBeLimited) GTEST_SKIP();
  const VisualDesc desc = test::make_scene();
  const test::Gpu software = test::make_gpu("llvmpipe");
  RenderOptions large;
  large.extent = {8192, 4096};
  large.quality = kQualityLevels.back();
  const auto made = Renderer::create(*software.device, desc, large);
  ASSERT_TRUE(made) << made.error().sentence;
  Renderer& renderer = **made;
  AutoQuality choice;
  while (choice.quality() != kQualityLevels.front()) choice.add(0.001);
  {
    const LimitedRoom room(400'000'000);
    ASSERT_TRUE(renderer.set_quality(kQualityLevels.front()));
    EXPECT_TRUE(renderer.is_short_of_memory());
    ASSERT_FALSE(take_quality(renderer, choice));
  }
  EXPECT_EQ(renderer.quality(), choice.quality());
  EXPECT_NE(choice.quality(), kQualityLevels.front());
  EXPECT_NE(choice.quality(), kQualityLevels.back());
  EXPECT_FALSE(renderer.is_short_of_memory());
  EXPECT_EQ(draw(renderer, desc).width, 8192U);
}

// Two colours that 255 linear parts do not tell apart, and a screen shows four apart.
TEST_F(RendererTest, DarkColoursOfVerticesAreToldApart) {
  VisualDesc desc = test::make_scene();
  desc.materials[0] = {"floor", glm::vec3(1.0F), 0.0F, 1.0F};
  const auto floor = [&](float linear) {
    desc.meshes[0].colours.assign(desc.meshes[0].positions.size(), glm::vec3(linear));
    return test::mean(draw(*make(desc, small_), desc), 0.05F, 0.80F, 0.20F, 0.95F).g;
  };
  EXPECT_GT(floor(0.0050F), floor(0.0035F) + 0.5F);
}

// How much each pixel differs from the mean of its neighbours left and right, or above and below (stride:
// bytes to the next).
std::size_t roughness(const Picture& picture, std::size_t stride) {
  std::size_t sum = 0;
  for (std::size_t i = stride; i + stride < picture.rgba.size(); i += 4)
    sum += static_cast<std::size_t>(
        std::abs(2 * picture.rgba[i + 1] - picture.rgba[i + 1 - stride] - picture.rgba[i + 1 + stride]));
  return sum;
}

// Drawn at half the resolution it is like one that is drawn whole, and has no value beyond what that has: an
// edge is followed by no brighter or darker line.
TEST_F(RendererTest, ASceneThatIsEnlargedIsLikeAWholeOne) {
  const VisualDesc desc = test::make_scene();
  RenderOptions half = small_;
  half.quality.resolution_scale = 0.5F;
  const Picture whole = draw(*make(desc, small_), desc);
  const Picture enlarged = draw(*make(desc, half), desc);
  ASSERT_EQ(enlarged.rgba.size(), whole.rgba.size());
  std::size_t sum = 0;
  std::array<std::pair<int, int>, 2> range{{{255, 0}, {255, 0}}};
  for (std::size_t i = 0; i < whole.rgba.size(); i += 4) {
    sum += static_cast<std::size_t>(std::abs(whole.rgba[i + 1] - enlarged.rgba[i + 1]));
    for (const auto& [picture, of] : {std::pair(&whole, &range[0]), std::pair(&enlarged, &range[1])}) {
      of->first = std::min<int>(of->first, picture->rgba[i + 1]);
      of->second = std::max<int>(of->second, picture->rgba[i + 1]);
    }
  }
  EXPECT_LT(sum, 3 * whole.rgba.size() / 4);  // of 255, on average
  // It has no steps or combs that the whole one has not.
  EXPECT_LT(roughness(enlarged, 4), roughness(whole, 4));
  EXPECT_LT(roughness(enlarged, std::size_t{4} * whole.width),
            roughness(whole, std::size_t{4} * whole.width));
  EXPECT_GE(range[1].first + 4, range[0].first);
  EXPECT_LE(range[1].second, range[0].second + 4);
}

TEST_F(RendererTest, AStateThatDoesNotFitIsRefusedWithASentence) {
  const VisualDesc desc = test::make_scene();
  const std::unique_ptr<Renderer> renderer = make(desc, small_);
  const std::optional<Error> none = renderer->frame({});
  ASSERT_TRUE(none);
  EXPECT_NE(none->sentence.find("0 poses, but the scene has 1"), std::string::npos);
  const std::vector<MarkerState> two(2);
  FrameState state;
  state.X_WM = {&desc.instances[2].X_WM, 1};
  state.markers = two;
  EXPECT_TRUE(renderer->frame(state));
}

TEST_F(RendererTest, OneSampleAndFourAgreeAwayFromEdges) {
  const VisualDesc desc = test::make_scene();
  RenderOptions one = small_;
  one.quality.samples = 1;
  const Picture a = draw(*make(desc, small_), desc);
  const Picture b = draw(*make(desc, one), desc);
  const glm::vec3 difference = test::mean(a, 0.0F, 0.8F, 1.0F, 1.0F) - test::mean(b, 0.0F, 0.8F, 1.0F, 1.0F);
  EXPECT_LT(glm::length(difference), 1.0F);
}

}  // namespace
}  // namespace fulcrum::render
