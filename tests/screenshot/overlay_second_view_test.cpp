// The frame and the name of a second view, marks of touch and the way to a tool that is out of the picture:
// looked for in the picture's pixels.

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include "overlay_fixture.h"

namespace fulcrum::ui {
namespace {

class OverlaySecondViewTest : public OverlayTest {
protected:
  void size(render::Extent extent) {
    renderer_ =
        std::move(*render::Renderer::create(*gpu_.device, test::make_scene(), {extent, {1, 0, 1.0F}, {}}));
  }

  static OverlayState second_view_state() {
    OverlayState state = full_state();
    state.message.clear();
    state.second_view = SecondView{"from the side", {}};
    return state;
  }

  // With the second view, as a window draws it.
  render::Picture shown(const OverlayState& state, float ball_z = 0.0F) {
    const std::optional<vulkan::Error> error = overlay_->prepare(state, renderer_->plan().picture);
    EXPECT_FALSE(error) << error->sentence;
    const std::vector<glm::mat4> poses = {
        glm::mat4({1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0.1F, 0.12F, ball_z, 1})};
    render::FrameState frame;
    frame.X_WM = poses;
    frame.camera = test::make_scene().camera;
    frame.overlay = overlay_.get();
    if (const auto& place = overlay_->second_view())
      frame.inset = {
          {{0.7F, 0.2F, 0.0F}, {0.0F, 0.08F, 0.0F}, 0.6F}, place->x, place->y, place->width, place->height};
    EXPECT_FALSE(renderer_->frame(frame));
    return *renderer_->read_back();
  }

  static const std::uint8_t* pixel(const render::Picture& picture, std::uint32_t x, std::uint32_t y) {
    return &picture.rgba[4 * (std::size_t{y} * picture.width + x)];
  }
  static bool is_frame(const std::uint8_t* rgba) {
    return std::abs(rgba[0] - 158) < 14 && std::abs(rgba[1] - 169) < 14 && std::abs(rgba[2] - 182) < 14;
  }
  static int differing(const render::Picture& a, const render::Picture& b, const PixelArea& area) {
    int count = 0;
    for (std::uint32_t y = area.y; y < area.y + area.height; ++y)
      for (std::uint32_t x = area.x; x < area.x + area.width; ++x) {
        int most = 0;
        for (int c = 0; c < 3; ++c) most = std::max(most, std::abs(pixel(a, x, y)[c] - pixel(b, x, y)[c]));
        count += most > 30 ? 1 : 0;
      }
    return count;
  }
};

TEST_F(OverlaySecondViewTest, HasAFrameANameAndTheToolInIt) {
  for (const render::Extent extent : {render::Extent{640, 360}, render::Extent{1280, 720}}) {
    size(extent);
    OverlayState state = second_view_state();
    const render::Picture picture = shown(state);
    ASSERT_TRUE(overlay_->second_view());
    const PixelArea at = *overlay_->second_view();
    EXPECT_GE(at.width, extent.width / 5);
    EXPECT_NEAR(static_cast<double>(at.width) / at.height, 1.6, 0.05);
    // Of the frame's pixels on each side nearly all have its colour; the name lies over the top left.
    int left = 0, right = 0, bottom = 0;
    for (std::uint32_t i = at.height / 4; i < at.height; ++i) {
      left += is_frame(pixel(picture, at.x, at.y + i)) ? 1 : 0;
      right += is_frame(pixel(picture, at.x + at.width - 1, at.y + i)) ? 1 : 0;
    }
    for (std::uint32_t i = 0; i < at.width; ++i)
      bottom += is_frame(pixel(picture, at.x + i, at.y + at.height - 1)) ? 1 : 0;
    EXPECT_GT(left, 0.7 * at.height);
    EXPECT_GT(right, 0.7 * at.height);
    EXPECT_GT(bottom, 0.9 * at.width);

    state.second_view->name = "down the canal";
    const render::Picture renamed = shown(state);
    const PixelArea head{at.x, at.y, at.width, at.height / 4},
        below{at.x, at.y + at.height / 4, at.width, at.height - at.height / 4};
    EXPECT_GT(differing(picture, renamed, head), 20) << "its name is written";
    EXPECT_EQ(differing(picture, renamed, below), 0);
    EXPECT_GT(differing(shown(state, 0.15F), renamed, below), 30) << "the ball is seen in it, and moves";

    state.second_view.reset();
    const render::Picture without = shown(state);
    EXPECT_FALSE(overlay_->second_view());
    EXPECT_GT(differing(picture, without, at), static_cast<int>(at.width * at.height / 8));
  }
}

TEST_F(OverlaySecondViewTest, LeavesPanelsAloneAndGivesWayWhereThereIsNoRoom) {
  size({640, 360});
  OverlayState state = second_view_state();
  state.motors = std::vector<MotorBar>(7, {"joint", 0.5, 0.0, 0.5});
  shown(state);
  ASSERT_TRUE(overlay_->second_view());
  // Seven motors: their panel's top is at 36 + 7 x 19 + 6 units from the margin, of three quarters of a
  // pixel.
  EXPECT_LE(overlay_->second_view()->y + overlay_->second_view()->height, 360 - 0.75 * (18 + 175));
  state.debrief = Debrief{"Completed", {}, ""};
  shown(state);
  EXPECT_FALSE(overlay_->second_view()) << "a card is in the middle";
  size({160, 90});
  state.debrief.reset();
  shown(state);
  EXPECT_FALSE(overlay_->second_view()) << "there is no room";
}

TEST_F(OverlaySecondViewTest, TouchesAreMarkedInBothViewsAndLargerTheHarder) {
  size({640, 360});
  OverlayState state = second_view_state();
  const render::Picture none = shown(state);
  const PixelArea at = *overlay_->second_view();
  const auto changed = [&](const PixelArea& area) { return differing(none, shown(state), area); };
  const PixelArea around{300, 150, 60, 60};
  state.touches = {{{330, 190}, {330, 170}, 0.05F}};
  const int light = changed(around);
  EXPECT_GT(light, 20);
  EXPECT_EQ(changed(at), 0) << "not in the other one";
  state.touches = {{{330, 190}, {330, 160}, 1.0F}};
  EXPECT_GT(changed(around), light + 40);
  state.touches.clear();
  state.second_view->touches = {{{0.5F, 0.6F}, {0.5F, 0.4F}, 0.5F}, {{1.5F, 0.5F}, {1.5F, 0.4F}, 1.0F}};
  EXPECT_GT(changed(at), 20);
  EXPECT_EQ(changed({0, 0, at.x - 2, 360}), 0) << "and what is out of it is nowhere";
}

TEST_F(OverlaySecondViewTest, AnArrowPointsToALostTool) {
  size({640, 360});
  OverlayState state = full_state();
  state.message.clear();
  const render::Picture none = shown(state);
  state.tool = EdgePlace{{640, 180}, {1, 0}, "the tip"};
  const render::Picture lost = shown(state);
  int white = 0;
  for (std::uint32_t y = 160; y < 200; ++y)
    for (std::uint32_t x = 560; x < 640; ++x)
      white += pixel(lost, x, y)[0] > 225 && pixel(lost, x, y)[2] > 235 && pixel(none, x, y)[0] < 200 ? 1 : 0;
  EXPECT_GT(white, 60) << "a white arrow at the right edge";
  EXPECT_GT(differing(lost, none, {480, 150, 100, 60}), 60) << "and its name beside it";
}

// The band is light inside the arc: from a value's 1/1.1 to its 1.1.
TEST_F(OverlaySecondViewTest, AGaugeMarksWhatFeelsTheSame) {
  size({1280, 720});
  OverlayState state = full_state();
  state.torque_Nm = {};
  state.force_N = {4.0, 8.0};
  const render::Picture picture = shown(state);
  const auto brightness = [&](double newtons) {
    const double angle = std::acos(-1.0) * (0.8 + 1.4 * newtons / 8.0);
    const double x = 18 + 71 + 45.5 * std::cos(angle), y = 720 - 18 - 148 + 84 + 45.5 * std::sin(angle);
    const std::uint8_t* at = pixel(picture, static_cast<std::uint32_t>(std::lround(x)),
                                   static_cast<std::uint32_t>(std::lround(y)));
    return at[0] + at[1] + at[2];
  };
  for (const double inside : {3.7, 4.3}) EXPECT_GT(brightness(inside), 300) << inside;
  for (const double outside : {3.3, 4.8}) EXPECT_LT(brightness(outside), 200) << outside;
}

}  // namespace
}  // namespace fulcrum::ui
