// Both eyes are drawn at once, each into a layer of its own. What either layer holds is, to the last bit,
// what a renderer for one eye draws by that eye's camera. The reference is that renderer, never a stored
// picture.

#include <gtest/gtest.h>

#include <glm/ext/matrix_transform.hpp>

#include "test_scene.h"

namespace fulcrum::render {
namespace {

constexpr Extent kWhole{320, 180}, kHalf{160, 180};

// As a headset has them: neither sees what the other one does, nor as widely. The floor reaches behind both,
// and beyond every side of what they see.
std::array<Camera, 2> eyes_of_a_headset() {
  Camera left{{-0.05F, 0.3F, 0.5F}, {-0.02F, 0.05F, 0.0F}, 0.9F};
  left.aspect = 1.2F;
  left.lean = {-0.3F, 0.1F};
  Camera right{{0.06F, 0.33F, 0.48F}, {0.05F, 0.05F, 0.0F}, 0.7F};
  right.aspect = 1.0F;
  right.lean = {0.25F, -0.15F};
  return {left, right};
}

// The test scene with a floor that has holes and a box that is seen through.
VisualDesc detailed_scene() {
  VisualDesc desc = test::make_scene();
  desc.textures = {{"holes", 2, 2, {200, 90, 30, 255, 0, 0, 0, 0, 0, 0, 0, 0, 40, 120, 200, 255}, true}};
  Mesh& floor = desc.meshes.front();
  for (const glm::vec3& p : floor.positions) floor.uv.emplace_back(6.0F * p.x, 6.0F * p.z, 0.0F, 0.0F);
  SurfaceDetail& holes = desc.materials[0].detail.emplace();
  holes.alpha = Alpha::mask;
  holes.layers[SurfaceDetail::base_colour].emplace();
  SurfaceDetail& glass = desc.materials[1].detail.emplace();
  glass.alpha = Alpha::blend;
  glass.opacity = 0.4F;
  glass.double_sided = true;
  return desc;
}

class TwoEyesTest : public testing::Test {
protected:
  void TearDown() override {
    for (const std::string& message : gpu_.instance.messages()) ADD_FAILURE() << message;
  }

  Picture drawn(const VisualDesc& desc, Extent extent, const Quality& quality, std::optional<StereoMode> mode,
                const FrameState& frame) {
    RenderOptions options{extent, quality, {}, {}};
    if (mode) options.stereo = Stereo{*mode};
    auto renderer = Renderer::create(*gpu_.device, desc, options);
    if (!renderer) throw std::runtime_error(renderer.error().sentence);
    const std::optional<Error> error = (*renderer)->frame(frame);
    EXPECT_FALSE(error) << error->sentence;
    return *(*renderer)->read_back();
  }

  FrameState state(const VisualDesc& desc) {
    poses_ = {desc.instances[2].X_WM};
    ghost_ = {1.0F, glm::translate(poses_[0], {0.05F, 0.03F, 0.05F})};
    FrameState state;
    state.X_WM = poses_;
    state.markers = markers_;
    state.eyes = eyes_of_a_headset();
    return state;
  }

  test::Gpu gpu_ = test::make_gpu("llvmpipe");
  std::vector<glm::mat4> poses_;
  GhostState ghost_;
  std::vector<MarkerState> markers_ = {{MarkerState::Show::dwelling, 0.4F}};
};

std::size_t apart(const Picture& a, std::size_t a_at, const Picture& b, std::size_t b_at, std::size_t bytes) {
  std::size_t differing = 0;
  for (std::size_t i = 0; i < bytes; ++i) differing += a.rgba[a_at + i] == b.rgba[b_at + i] ? 0 : 1;
  return differing;
}

// A ghost's lines are as wide as the whole picture asks for: without it here, with it where rows alternate.
TEST_F(TwoEyesTest, EitherHalfIsWhatThatEyeAloneSees) {
  for (const VisualDesc& desc : {test::make_scene(), detailed_scene()})
    for (const Quality& quality : {Quality{4, 512, 1.0F, 0.0F, true}, Quality{1, 512, 0.6F, 0.0F, true},
                                   Quality{1, 0, 1.0F, 0.0F, false}}) {
      const FrameState both = state(desc);
      const Picture picture = drawn(desc, kWhole, quality, StereoMode::side_by_side, both);
      for (std::size_t eye = 0; eye < 2; ++eye) {
        FrameState alone = both;
        alone.camera = (*both.eyes)[eye];
        const Picture expected = drawn(desc, kHalf, quality, {}, alone);
        std::size_t differing = 0;
        for (std::size_t y = 0; y < kHalf.height; ++y)
          differing += apart(picture, (y * kWhole.width + eye * kHalf.width) * 4, expected,
                             y * kHalf.width * 4, std::size_t{4} * kHalf.width);
        EXPECT_EQ(differing, 0U) << (eye == 0 ? "left, " : "right, ") << quality.samples << " samples, scale "
                                 << quality.resolution_scale;
      }
    }
}

TEST_F(TwoEyesTest, EitherHasItsOwnLinesOfTheGhost) {
  const VisualDesc desc = detailed_scene();
  for (const Quality& quality : {Quality{4, 512, 1.0F, 0.0F, true}, Quality{1, 512, 0.6F, 0.0F, true}}) {
    FrameState both = state(desc);
    both.ghosts = {&ghost_, 1};
    const Picture picture = drawn(desc, kWhole, quality, StereoMode::interlaced, both);
    for (std::size_t eye = 0; eye < 2; ++eye) {
      FrameState alone = both;
      alone.camera = (*both.eyes)[eye];
      const Picture expected = drawn(desc, kWhole, quality, {}, alone);
      std::size_t differing = 0;
      for (std::size_t y = eye; y < kWhole.height; y += 2)
        differing += apart(picture, y * kWhole.width * 4, expected, y * kWhole.width * 4,
                           std::size_t{4} * kWhole.width);
      EXPECT_EQ(differing, 0U) << (eye == 0 ? "left" : "right");
    }
  }
}

}  // namespace
}  // namespace fulcrum::render
