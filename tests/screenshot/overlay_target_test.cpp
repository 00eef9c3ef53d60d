// The way to the next checkpoint, the trial's clock and what came of it, over a picture: looked for by their
// colours where they have to be.

#include <gtest/gtest.h>

#include <cmath>
#include <glm/glm.hpp>
#include <utility>

#include "image_compare.h"
#include "overlay_fixture.h"
#include "overlay_parts.h"

namespace fulcrum::ui {
namespace {

class OverlayTargetTest : public OverlayTest {
protected:
  static constexpr float kWidth = 640.0F, kHeight = 360.0F;  // px

  // Mean of a square about a place, px.
  static glm::vec3 at(const render::Picture& picture, const glm::vec2& px, float half = 1.0F) {
    return test::mean(picture, (px.x - half) / kWidth, (px.y - half) / kHeight, (px.x + half) / kWidth,
                      (px.y + half) / kHeight);
  }
  static bool is_blue(const glm::vec3& colour) { return colour.b > colour.r + 60.0F; }
  static bool is_orange(const glm::vec3& colour) { return colour.r > colour.b + 60.0F; }

  // In the middle, which no panel reaches; its ring has a radius of 40 px and 3 units.
  static OverlayState in_sight() {
    OverlayState state = full_state();
    state.message.clear();
    state.target = nut_in_sight(0.012, 40);
    return state;
  }
  static constexpr float kRing = 40.0F + 3.0F * 0.75F;  // px

  // From left to right, the first and the last column in which the pictures differ; -1: none.
  static std::pair<int, int> columns_that_differ(const render::Picture& a, const render::Picture& b) {
    std::pair<int, int> columns{-1, -1};
    for (int x = 0; x < static_cast<int>(kWidth); ++x) {
      const float left = static_cast<float>(x) / kWidth, right = (static_cast<float>(x) + 1.0F) / kWidth;
      bool differs = false;
      for (int y = 0; y < static_cast<int>(kHeight) && !differs; ++y) {
        const float top = static_cast<float>(y) / kHeight, bottom = (static_cast<float>(y) + 1.0F) / kHeight;
        differs = glm::length(test::mean(a, left, top, right, bottom) -
                              test::mean(b, left, top, right, bottom)) > 8.0F;
      }
      if (!differs) continue;
      if (columns.first < 0) columns.first = x;
      columns.second = x;
    }
    return columns;
  }
};

TEST_F(OverlayTargetTest, ARingIsAroundTheTargetAndALabelBesideIt) {
  OverlayState state = in_sight();
  const render::Picture with = draw(state);
  const glm::vec2 middle = state.target->at.place;
  for (const glm::vec2 way : {glm::vec2(0, -1), glm::vec2(-1, 0), glm::vec2(0, 1)})
    EXPECT_TRUE(is_blue(at(with, middle + kRing * way)));
  EXPECT_FALSE(is_blue(at(with, middle)));
  state.target.reset();
  const auto [first, last] = columns_that_differ(with, draw(state));
  EXPECT_NEAR(static_cast<float>(first), middle.x - kRing, 4.0F);
  EXPECT_GT(static_cast<float>(last), middle.x + kRing + 60.0F);  // the label
}

// Beside the touch point, as long as the drag: up where the target is farther, down where it is nearer.
TEST_F(OverlayTargetTest, AnArrowIsAsLongAsTheDragThatTheDepthTakes) {
  OverlayState state = in_sight();
  const glm::vec2 touch{250, 200};
  const float side = 18.0F * 0.75F;
  state.target->at.touch = touch;
  const auto violet = [&](const render::Picture& picture, float up) {
    const glm::vec3 colour = at(picture, touch + glm::vec2(side, -up), 0.5F);
    return colour.b > colour.g + 60.0F && colour.r > colour.g + 60.0F;
  };
  const render::Picture none = draw(state);
  for (const float up : {-55.0F, -30.0F, 0.0F, 30.0F, 55.0F}) EXPECT_FALSE(violet(none, up)) << up;
  state.target->at.farther = {0.04, 60.0F};
  const render::Picture up = draw(state);
  for (const float inside : {2.0F, 30.0F, 55.0F}) EXPECT_TRUE(violet(up, inside)) << inside;
  for (const float outside : {-6.0F, 63.0F}) EXPECT_FALSE(violet(up, outside)) << outside;
  state.target->at.farther = {-0.04, -60.0F};
  const render::Picture down = draw(state);
  for (const float inside : {-2.0F, -30.0F, -55.0F}) EXPECT_TRUE(violet(down, inside)) << inside;
  for (const float outside : {6.0F, -63.0F}) EXPECT_FALSE(violet(down, outside)) << outside;
  // Once the tool is in the checkpoint nothing is left to do but to stay.
  state.target->dwelling = true;
  EXPECT_FALSE(violet(draw(state), -30.0F));
}

// A depth beyond the picture: the arrow's tip stays in it.
TEST_F(OverlayTargetTest, AnArrowStaysInThePicture) {
  OverlayState state = in_sight();
  state.target->at.touch = glm::vec2(630, 120);  // no room to its right
  state.target->at.farther = {0.5, 5000.0F};
  const float x = 630 - 18.0F * 0.75F, tip = 18.0F * 0.75F;
  const glm::vec3 colour = at(draw(state), {x, tip + 5.0F}, 0.5F);
  EXPECT_GT(colour.b, colour.g + 60.0F);
}

TEST_F(OverlayTargetTest, ADwellIsAnArcClockwiseFromTheTop) {
  OverlayState state = in_sight();
  state.target->dwelling = true;
  state.target->progress = 0.25F;
  const render::Picture quarter = draw(state);
  const glm::vec2 middle = state.target->at.place;
  const float outside = kRing + 6.0F * 0.75F, diagonal = outside / std::sqrt(2.0F);
  EXPECT_TRUE(is_orange(at(quarter, middle + glm::vec2(diagonal, -diagonal))));
  EXPECT_FALSE(is_orange(at(quarter, middle + glm::vec2(diagonal, diagonal))));
  EXPECT_FALSE(is_orange(at(quarter, middle + glm::vec2(-diagonal, -diagonal))));
  state.target->progress = 0.75F;
  const render::Picture most = draw(state);
  EXPECT_TRUE(is_orange(at(most, middle + glm::vec2(-diagonal, diagonal))));
  EXPECT_FALSE(is_orange(at(most, middle + glm::vec2(-diagonal, -diagonal))));
}

// To the right of the picture and above its middle, where a panel is: nothing is drawn over that.
TEST_F(OverlayTargetTest, AnArrowKeepsClearOfThePanels) {
  OverlayState state = in_sight();
  state.target->at.in_sight = false;
  state.target->at.radius = 0;
  state.target->at.way = glm::normalize(glm::vec2(320, -145));
  state.target->at.place = {640, 35};
  const render::Picture with = draw(state);
  state.target.reset();
  const render::Picture without = draw(state);
  const auto panel = [](const render::Picture& picture) {
    return test::mean(picture, 0.70F, 0.02F, 0.99F, 0.137F);
  };
  EXPECT_EQ(panel(with), panel(without));
  const auto [first, last] = columns_that_differ(with, without);
  EXPECT_GT(first, 400);
  EXPECT_LT(last, 640 - static_cast<int>(0.75F * 18.0F) + 4);
}

TEST_F(OverlayTargetTest, ALabelStaysInThePicture) {
  OverlayState state = in_sight();
  state.target->name = "a checkpoint whose name is far too long for any picture, and goes on and on and on";
  state.target->at.radius = 4;
  for (const glm::vec2 place : {glm::vec2(638, 180), glm::vec2(300, 2), glm::vec2(250, 358)}) {
    state.target->at.place = place;
    const render::Picture with = draw(state);
    OverlayState none = state;
    none.target.reset();
    const auto [first, last] = columns_that_differ(with, draw(none));
    EXPECT_GE(first, static_cast<int>(0.75F * 18.0F) - 1);
    // But for the ring, which is where the target is.
    if (place.x < 600.0F) EXPECT_LE(last, 640 - static_cast<int>(0.75F * 18.0F));
  }
}

TEST_F(OverlayTargetTest, ThePlumbLineGoesDownAndThenLevel) {
  OverlayState state = in_sight();
  state.target->at.touch = glm::vec2(420, 90);
  state.target->at.drop = Segment{{420, 90}, {420, 200}};
  state.target->at.level = Segment{{420, 200}, {350, 180}};
  const auto column = [&] { return at(draw(state), {420, 140}, 2.0F); };
  const glm::vec3 with = column();
  state.target->at.drop.reset();
  const glm::vec3 without = column();
  EXPECT_GT(glm::length(with - without), 8.0F);
  state.target->at.drop = Segment{{420, 90}, {420, 200}};
  state.target->dwelling = true;  // then there is no way left to show
  EXPECT_LT(glm::length(column() - without), 0.5F);
}

TEST_F(OverlayTargetTest, TheTouchPointIsNamedOnlyWhereItHasAName) {
  OverlayState state = in_sight();
  state.target->at.touch = glm::vec2(300, 60);
  const render::Picture plain = draw(state);
  EXPECT_GT(at(plain, {300, 60}, 2.0F).g, 130.0F);  // its mark
  state.target->touch_name = "the spanner's ring";
  const auto [first, last] = columns_that_differ(draw(state), plain);
  EXPECT_GT(first, 300);
  EXPECT_LT(last, 460);
}

TEST_F(OverlayTargetTest, TheClockIsInTheListOfCheckpointsAndWarnsAtTheEnd) {
  OverlayState state = full_state();
  const auto head = [&] { return test::mean(draw(state), 0.02F, 0.11F, 0.18F, 0.15F); };
  const glm::vec3 none = head();
  state.trial = {12, 90, 0};
  const glm::vec3 calm = head();
  EXPECT_GT(calm.g, none.g + 2.0F);
  state.trial = {85, 90, 0};
  const glm::vec3 late = head();
  EXPECT_GT(late.r - late.b, calm.r - calm.b + 2.0F);
}

TEST_F(OverlayTargetTest, TheDebriefIsInTheMiddleWhateverItsLength) {
  OverlayState state = full_state();
  const glm::vec3 none = test::mean(draw(state), 0.4F, 0.4F, 0.6F, 0.6F);
  state.debrief = Debrief{"Completed in 44.1 s", {{"Time", "44.1 s", "80", "of 90 s"}}, "R starts again."};
  EXPECT_GT(glm::length(test::mean(draw(state), 0.4F, 0.4F, 0.6F, 0.6F) - none), 10.0F);
  for (int i = 0; i < 100; ++i)
    state.debrief->rows.push_back({"a checkpoint with a long name, " + std::to_string(i),
                                   "1.0 s",
                                   {},
                                   "a reason that is longer than any picture has room for, and goes on"});
  const render::Picture full = draw(state);
  const glm::vec3 foot = test::mean(full, 0.4F, 0.90F, 0.6F, 0.94F),
                  edge = test::mean(full, 0.4F, 0.98F, 0.6F, 0.995F);
  EXPECT_GT(glm::length(foot - edge), 4.0F);
}

TEST_F(OverlayTargetTest, FiguresAreShownWhenAskedForAndTroubleWithout) {
  OverlayState state = full_state();
  state.message.clear();
  state.ticks = {.rate_Hz = 1000, .late = 12, .lost = 3};
  const auto below = [&] { return test::mean(draw(state), 0.75F, 0.12F, 0.97F, 0.25F); };
  const auto beside = [&] { return test::mean(draw(state), 0.52F, 0.05F, 0.70F, 0.09F); };
  const glm::vec3 plain = below(), calm = beside();
  state.ticks.trouble = true;
  const glm::vec3 red = beside();
  EXPECT_GT(red.r - red.b, calm.r - calm.b + 3.0F);
  EXPECT_NEAR(glm::length(below() - plain), 0.0F, 0.5F);
  state.figures_visible = true;
  EXPECT_GT(glm::length(below() - plain), 5.0F);
  EXPECT_NEAR(glm::length(beside() - calm), 0.0F, 0.5F);
}

}  // namespace
}  // namespace fulcrum::ui
