// A second view in a part of the picture: what its own camera sees there, and nothing of it elsewhere.

#include <gtest/gtest.h>

#include <cstdlib>
#include <glm/ext/matrix_transform.hpp>

#include "test_scene.h"

namespace fulcrum::render {
namespace {

const Camera kSide{{0.7F, 0.2F, 0.0F}, {0.0F, 0.08F, 0.0F}, 0.6F};
constexpr Extent kPicture{320, 180}, kSmall{96, 60};
constexpr std::uint32_t kX = 210, kY = 100;

class InsetTest : public testing::Test {
protected:
  void TearDown() override {
    for (const std::string& message : gpu_.instance.messages()) ADD_FAILURE() << message;
  }

  std::unique_ptr<Renderer> make(const VisualDesc& desc, Extent extent,
                                 const Quality& quality = {4, 512, 1.0F}) {
    auto made = Renderer::create(*gpu_.device, desc, {extent, quality, {}});
    if (!made) throw std::runtime_error(made.error().sentence);
    return std::move(*made);
  }

  // The test scene with its ghost beside the ball.
  FrameState state(const Camera& camera) {
    FrameState state;
    state.X_WM = poses_;
    state.markers = markers_;
    ghost_ = {1.0F, glm::translate(poses_[0], {0.05F, 0.03F, 0.05F})};
    state.ghosts = {&ghost_, 1};
    state.camera = camera;
    return state;
  }

  static Picture drawn(Renderer& renderer, const FrameState& state) {
    const std::optional<Error> error = renderer.frame(state);
    EXPECT_FALSE(error) << error->sentence;
    return *renderer.read_back();
  }

  // How far values are apart in the inset and beside it; inset: what should be there.
  struct Apart {
    int inside = 0, outside = 0;
  };
  static Apart apart(const Picture& picture, const Picture& without, const Picture& inset) {
    Apart most;
    for (std::uint32_t y = 0; y < picture.height; ++y)
      for (std::uint32_t x = 0; x < picture.width; ++x)
        for (std::size_t c = 0; c < 3; ++c) {
          const bool inside = x >= kX && x < kX + inset.width && y >= kY && y < kY + inset.height;
          const std::size_t at = (std::size_t{y} * picture.width + x) * 4 + c;
          const int expected =
              inside ? inset.rgba[(std::size_t{y - kY} * inset.width + (x - kX)) * 4 + c] : without.rgba[at];
          int& of = inside ? most.inside : most.outside;
          of = std::max(of, std::abs(int{picture.rgba[at]} - expected));
        }
    return most;
  }

  test::Gpu gpu_ = test::make_gpu("llvmpipe");
  VisualDesc desc_ = test::make_scene();
  std::vector<glm::mat4> poses_ = {desc_.instances[2].X_WM};
  GhostState ghost_;
  std::vector<MarkerState> markers_ = {{MarkerState::Show::next, 1.0F}};
};

// The picture's own renderer draws what another would draw of that size by that camera. A value may be one
// off: the noise that hides steps goes by the place in the whole picture.
TEST_F(InsetTest, IsWhatItsCameraSees) {
  const auto whole = make(desc_, kPicture), small = make(desc_, kSmall);
  const Picture without = drawn(*whole, state(desc_.camera)), expected = drawn(*small, state(kSide));
  FrameState both = state(desc_.camera);
  both.inset = {kSide, kX, kY, kSmall.width, kSmall.height};
  const Apart first = apart(drawn(*whole, both), without, expected);
  EXPECT_LE(first.inside, 1);
  EXPECT_EQ(first.outside, 0);
}

TEST_F(InsetTest, ShowsTheToolWhereItIsNow) {
  const auto whole = make(desc_, kPicture), small = make(desc_, kSmall);
  FrameState both = state(desc_.camera);
  both.inset = {kSide, kX, kY, kSmall.width, kSmall.height};
  const Picture before = drawn(*whole, both);
  poses_[0] = glm::translate(glm::mat4(1.0F), {0.0F, 0.15F, 0.12F});
  FrameState moved = state(desc_.camera);
  const Picture without = drawn(*whole, moved), expected = drawn(*small, state(kSide));
  moved.inset = both.inset;
  const Picture after = drawn(*whole, moved);
  EXPECT_LE(apart(after, without, expected).inside, 1);
  EXPECT_GT(apart(before, without, expected).inside, 60) << "it had been elsewhere";
}

// What only one of them sees throws its shadow there alone.
TEST_F(InsetTest, SeesItsOwnLayers) {
  desc_.instances[1].layers = 2;  // the box, in the second view alone
  desc_.instances[0].layers = desc_.instances[2].layers = 3;
  Camera side = kSide;
  side.layers = 2;
  const auto whole = make(desc_, kPicture, {1, 512, 1.0F}), small = make(desc_, kSmall, {1, 512, 1.0F});
  const Picture without = drawn(*whole, state(desc_.camera)), expected = drawn(*small, state(side));
  FrameState both = state(desc_.camera);
  both.inset = {side, kX, kY, kSmall.width, kSmall.height};
  for (int frame = 0; frame < 2; ++frame) {  // the second one's map is drawn over the first one's
    const Apart found = apart(drawn(*whole, both), without, expected);
    EXPECT_LE(found.inside, 1);
    EXPECT_EQ(found.outside, 0);
  }
  EXPECT_TRUE(drawn(*whole, state(desc_.camera)).rgba == without.rgba);
}

TEST_F(InsetTest, IsBuiltWhileItIsShownAndNotBeforeOrAfter) {
  const auto is_built = [](const Renderer& renderer) {
    return std::ranges::any_of(renderer.plan().built,
                               [](const BuildItem& item) { return item.name == "second view"; });
  };
  const auto renderer = make(desc_, kPicture);
  const Picture before = drawn(*renderer, state(desc_.camera));
  EXPECT_FALSE(is_built(*renderer));
  FrameState both = state(desc_.camera);
  for (const Extent size : {kSmall, Extent{1, 1}, Extent{110, 80}}) {
    both.inset = {kSide, kX, kY, size.width, size.height};
    drawn(*renderer, both);
    EXPECT_TRUE(is_built(*renderer));
    EXPECT_EQ(renderer->plan().inset, size);
  }
  ASSERT_FALSE(renderer->set_quality({1, 0, 0.5F}));
  drawn(*renderer, both);
  ASSERT_FALSE(renderer->set_quality({4, 512, 1.0F}));
  EXPECT_TRUE(drawn(*renderer, state(desc_.camera)).rgba == before.rgba) << "not a bit of it is left";
  EXPECT_FALSE(is_built(*renderer));
}

TEST_F(InsetTest, BeyondThePictureItIsRefused) {
  const auto renderer = make(desc_, kPicture);
  FrameState both = state(desc_.camera);
  both.inset = {kSide, kX + 100, kY, kSmall.width, kSmall.height};
  const std::optional<Error> beyond = renderer->frame(both);
  ASSERT_TRUE(beyond);
  EXPECT_NE(beyond->sentence.find("beyond the picture"), std::string::npos);
  both.inset = {kSide, 0, 0, kPicture.width + 1, 10};
  const std::optional<Error> wider = renderer->frame(both);
  ASSERT_TRUE(wider);
  EXPECT_NE(wider->sentence.find("321 x 10"), std::string::npos);
  EXPECT_FALSE(renderer->frame(state(desc_.camera))) << "and the next frame is drawn";
}

TEST_F(InsetTest, AGhostMayComeLater) {
  VisualDesc bare = desc_;
  bare.ghosts.clear();
  const auto renderer = make(bare, kPicture);
  FrameState hidden = state(desc_.camera);
  hidden.ghosts = {};
  const Picture without = drawn(*renderer, hidden);
  EXPECT_TRUE(renderer->frame(state(desc_.camera))) << "there is none yet";
  ASSERT_FALSE(renderer->set_ghosts(desc_));
  EXPECT_TRUE(drawn(*renderer, hidden).rgba == without.rgba);
  EXPECT_TRUE(drawn(*renderer, state(desc_.camera)).rgba ==
              drawn(*make(desc_, kPicture), state(desc_.camera)).rgba)
      << "as of a scene that had it from the beginning";
  FrameState gold = state(desc_.camera);
  GhostState golden = ghost_;
  golden.colour = glm::vec3(1.0F, 0.5F, 0.0F);
  gold.ghosts = {&golden, 1};
  EXPECT_FALSE(drawn(*renderer, gold).rgba == drawn(*renderer, state(desc_.camera)).rgba);
}

}  // namespace
}  // namespace fulcrum::render
