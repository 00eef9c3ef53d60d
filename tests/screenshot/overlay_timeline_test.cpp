// The timeline of a trial that has ended: a press finds the time that is drawn there.

#include <cmath>

#include "engine/ui/timeline.h"
#include "overlay_fixture.h"

namespace fulcrum::ui {
namespace {

struct Knob {
  double x = 0, y = 0;  // pixels
  int pixels = 0;
};

// The middle of the round, blue thing at the bottom of the picture: of pixels whose column is blue for more
// than the bar.
Knob knob_in(const render::Picture& picture) {
  const auto blue = [&](std::uint32_t x, std::uint32_t y) {
    const std::uint8_t* const rgba = &picture.rgba[4 * (std::size_t{y} * picture.width + x)];
    return std::abs(rgba[0] - 84) < 12 && std::abs(rgba[1] - 164) < 12 && std::abs(rgba[2] - 255) < 12;
  };
  Knob knob;
  for (std::uint32_t x = 0; x < picture.width; ++x) {
    int column = 0;
    for (std::uint32_t y = 9 * picture.height / 10; y < picture.height; ++y) column += blue(x, y) ? 1 : 0;
    // The bar alone is 6 units high, the knob 14; a unit is 3/4 of a pixel at least.
    if (column < 9 * std::max(0.75, picture.height / 720.0)) continue;
    for (std::uint32_t y = 9 * picture.height / 10; y < picture.height; ++y) {
      if (!blue(x, y)) continue;
      knob.x += x;
      knob.y += y;
      ++knob.pixels;
    }
  }
  knob.x /= std::max(knob.pixels, 1);
  knob.y /= std::max(knob.pixels, 1);
  return knob;
}

class OverlayTimelineTest : public OverlayTest {};

TEST_F(OverlayTimelineTest, APressOnTheKnobFindsItsTime) {
  for (const render::Extent size : {render::Extent{640, 360}, render::Extent{1280, 720}}) {
    renderer_ = std::move(*render::Renderer::create(*gpu_.device, {}, {size, {1, 0, 1.0F}, {}}));
    for (const double at : {9.0, 15.0, 27.0}) {
      OverlayState state = full_state();
      state.message = "";
      state.force_N = state.torque_Nm = {};  // dials are blue, too
      state.timeline = {
          30.0, at, {{3.0, Timeline::Mark::Kind::good}, {12.0, Timeline::Mark::Kind::bad}}, "9.0 s"};
      const Knob knob = knob_in(draw(state));
      ASSERT_GT(knob.pixels, 20);
      const double height = size.height;
      const auto found = timeline_time(state, size, knob.x / height, knob.y / height, false);
      ASSERT_TRUE(found);
      EXPECT_NEAR(*found, at, 0.25);
      EXPECT_FALSE(timeline_time(state, size, knob.x / height, 0.5, false)) << "far above it";
      EXPECT_TRUE(timeline_time(state, size, knob.x / height, 0.5, true)) << "but a drag goes on";
      EXPECT_EQ(*timeline_time(state, size, 0, 0.5, true), 0);
      EXPECT_EQ(*timeline_time(state, size, 10, 0.5, true), 30);
    }
  }
}

// 1000 intervals of 30 s, in the 700th a peak that is narrower than a pixel, beyond its limit.
Timeline::Plot plot_with_peak(const std::string& name) {
  Timeline::Plot plot{name, "N", std::vector<double>(1000, 0.0), 0.03, 2.0};
  plot.largest[700] = 3.0;
  return plot;
}

struct RedPixels {
  double x = 0, lowest = 0, highest = 1e9;  // pixels
  int count = 0;
};

RedPixels red_in(const render::Picture& picture) {
  RedPixels red;
  for (std::uint32_t y = 0; y < picture.height; ++y)
    for (std::uint32_t x = 0; x < picture.width; ++x) {
      const std::uint8_t* const rgba = &picture.rgba[4 * (std::size_t{y} * picture.width + x)];
      if (rgba[0] < 180 || rgba[1] > 130 || rgba[2] > 130) continue;
      red.x += x;
      red.lowest = std::max<double>(red.lowest, y);
      red.highest = std::min<double>(red.highest, y);
      ++red.count;
    }
  red.x /= std::max(red.count, 1);
  return red;
}

TEST_F(OverlayTimelineTest, PlotsKeepPeaksAndAPressOnThemFindsTheirTime) {
  for (const render::Extent size : {render::Extent{640, 360}, render::Extent{1280, 720}}) {
    renderer_ = std::move(*render::Renderer::create(*gpu_.device, {}, {size, {1, 0, 1.0F}, {}}));
    OverlayState state = full_state();
    state.message = "";
    state.force_N = state.torque_Nm = {};
    state.keys = {};
    state.timeline = Timeline{.end_s = 30.0, .at_s = 9.0, .marks = {}, .caption = "9.0 s"};
    EXPECT_EQ(red_in(draw(state)).count, 0);
    for (const char* name : {"Force", "Torque", "Depth", "Speed"})
      state.timeline->plots.push_back(plot_with_peak(name));
    const RedPixels red = red_in(draw(state));
    ASSERT_GT(red.count, 4) << "a peak of a single interval is seen";
    const double height = size.height;
    for (const double y : {red.highest, red.lowest}) {
      const auto found = timeline_time(state, size, red.x / height, y / height, false);
      ASSERT_TRUE(found);
      EXPECT_NEAR(*found, 21.0, 0.1);
    }
    // As many as leave the scene two thirds of the picture: all four of them, or the first two.
    EXPECT_GT(red.highest, 0.62 * height);
    EXPECT_NEAR((red.lowest - red.highest) / height, size.height == 720 ? 3 * 38 / 720.0 : 38 / 480.0, 0.04);
    state.timeline->at_s.reset();
    EXPECT_EQ(red_in(draw(state)).count, 0) << "beside the card there are none";
  }
}

TEST_F(OverlayTimelineTest, OfATrialWithoutATickIsDrawn) {
  OverlayState state = full_state();
  state.timeline = Timeline{};
  draw(state);
  state.timeline->at_s = 0.0;
  state.timeline->plots = {{"Force", "N", {}, 0.0, {}}, {"Torque", "Nm", {0.0}, 0.0, 0.0}};
  draw(state);
  EXPECT_FALSE(timeline_time({}, {640, 360}, 0.5, 0.98, false)) << "without a timeline nothing is found";
}

}  // namespace
}  // namespace fulcrum::ui
