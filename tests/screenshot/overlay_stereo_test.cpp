// Panels and a second view in pictures for two eyes: at the screen, and so at the same place for either.

#include <algorithm>
#include <cstdlib>
#include <functional>

#include "overlay_fixture.h"

namespace fulcrum::ui {
namespace {

constexpr render::Extent kBothEyes{1280, 720};

class OverlayStereoTest : public OverlayTest {
protected:
  render::Picture shown(std::optional<render::StereoMode> mode, const OverlayState& state) {
    render::RenderOptions options{kBothEyes, {1, 0, 1.0F}, {}, {}};
    if (mode) options.stereo = render::Stereo{*mode};
    render::VisualDesc grey;  // an anaglyph changes other colours
    grey.background = {glm::vec3(0.3F), glm::vec3(0.1F)};
    renderer_ = std::move(*render::Renderer::create(*gpu_.device, grey, options));
    EXPECT_FALSE(overlay_->prepare(state, kBothEyes));
    render::FrameState frame;
    frame.overlay = overlay_.get();
    if (const auto& place = overlay_->second_view())
      frame.inset = {{}, place->x, place->y, place->width, place->height};
    EXPECT_FALSE(renderer_->frame(frame));
    return *renderer_->read_back();
  }

  // The largest difference of a value. expected: of the mono picture, what pixel (x, y) and channel c should
  // be.
  static int apart(const render::Picture& picture,
                   const std::function<int(std::size_t x, std::size_t y, std::size_t c)>& expected) {
    int most = 0;
    for (std::size_t y = 0; y < picture.height; ++y)
      for (std::size_t x = 0; x < picture.width; ++x)
        for (std::size_t c = 0; c < 3; ++c)
          most = std::max(most,
                          std::abs(int{picture.rgba[4 * (y * picture.width + x) + c]} - expected(x, y, c)));
    return most;
  }
  static int value(const render::Picture& picture, std::size_t x, std::size_t y, std::size_t c) {
    return picture.rgba[4 * (y * picture.width + x) + c];
  }

  // With something at every edge, and a second view.
  static OverlayState state() {
    OverlayState all = full_state();
    all.second_view = SecondView{"from the side", {}};
    return all;
  }
};

// The scene is empty: what differs would be the panels. They are drawn over nothing first, and rounded twice.
TEST_F(OverlayStereoTest, IsWhatItWouldBeForOneEye) {
  const render::Picture mono = shown({}, state());
  for (const render::StereoMode mode : {render::StereoMode::interlaced, render::StereoMode::anaglyph})
    EXPECT_LE(apart(shown(mode, state()), [&](auto x, auto y, auto c) { return value(mono, x, y, c); }), 4);
}

// In either half the whole of it, two pixels in the place of one.
TEST_F(OverlayStereoTest, IsSqueezedIntoEitherHalf) {
  const render::Picture mono = shown({}, state());
  const render::Picture beside = shown(render::StereoMode::side_by_side, state());
  EXPECT_LE(apart(beside,
                  [&](std::size_t x, std::size_t y, std::size_t c) {
                    const std::size_t first = 2 * (x % (kBothEyes.width / 2));
                    return (value(mono, first, y, c) + value(mono, first + 1, y, c)) / 2;
                  }),
            4);
  const render::Picture above = shown(render::StereoMode::top_bottom, state());
  EXPECT_LE(apart(above,
                  [&](std::size_t x, std::size_t y, std::size_t c) {
                    const std::size_t first = 2 * (y % (kBothEyes.height / 2));
                    return (value(mono, x, first, c) + value(mono, x, first + 1, c)) / 2;
                  }),
            4);
}

}  // namespace
}  // namespace fulcrum::ui
