// What the pointer of the tests in tests/person finds in a picture, against what the overlay was told to draw
// there.

#include <gtest/gtest.h>

#include <initializer_list>

#include "overlay_fixture.h"
#include "overlay_parts.h"
#include "tests/person/sight.h"

namespace fulcrum::ui {
namespace {

class PersonSightTest : public OverlayTest {
protected:
  person::Sight seen(const OverlayState& state) {
    const render::Picture drawn = draw(state);
    person::Picture picture{static_cast<int>(drawn.width), static_cast<int>(drawn.height), {}};
    for (std::size_t i = 0; i + 3 < drawn.rgba.size(); i += 4)
      picture.rgb.push_back(static_cast<std::uint32_t>(drawn.rgba[i]) << 16U |
                            static_cast<std::uint32_t>(drawn.rgba[i + 1]) << 8U | drawn.rgba[i + 2]);
    return person::look_at(picture);
  }

  static OverlayState on_the_way() {
    OverlayState state = full_state();
    state.message.clear();
    Target target = nut_in_sight(0.05, 20);
    target.at.touch = glm::vec2(250, 220);
    state.target = target;
    return state;
  }

  static void expect_near(const person::Place& place, const glm::vec2& px, double tolerance) {
    EXPECT_NEAR(place.x, static_cast<double>(px.x), tolerance);
    EXPECT_NEAR(place.y, static_cast<double>(px.y), tolerance);
  }
};

TEST_F(PersonSightTest, FindsRingMarkAndTicks) {
  OverlayState state = on_the_way();
  const TargetPlace& at = state.target->at;
  const person::Sight sight = seen(state);
  ASSERT_TRUE(sight.ring && sight.touch);
  expect_near(sight.ring->middle, at.place, 1);
  EXPECT_NEAR(sight.ring->radius, 20 + 3 * 0.75, 1);
  EXPECT_FALSE(sight.ring->filling);
  expect_near(*sight.touch, *at.touch, 1);
  EXPECT_EQ(sight.farther, 0);
  EXPECT_EQ(sight.done, 1);
  // The mark in the ring, the ring small, half of it outside, half of it behind a panel.
  for (const glm::vec2 place : {glm::vec2(354, 190), glm::vec2(350, 5), glm::vec2(185, 60)}) {
    state.target->at.place = place;
    state.target->at.radius = 3;
    const person::Sight small = seen(state);
    ASSERT_TRUE(small.ring && small.touch) << place.x;
    expect_near(small.ring->middle, place, 1.5);
    expect_near(*small.touch, *at.touch, 1);
  }
}

TEST_F(PersonSightTest, MeasuresTheDrag) {
  OverlayState state = on_the_way();
  for (const float drag : {90.0F, 25.0F, 7.0F, -7.0F, -25.0F, -90.0F}) {
    state.target->at.farther = Farther{0.001, drag};
    EXPECT_NEAR(seen(state).farther, static_cast<double>(drag), 2) << drag;
  }
}

TEST_F(PersonSightTest, SeesTheWayToALostTool) {
  OverlayState state = on_the_way();
  EXPECT_FALSE(seen(state).lost);
  state.target->at.touch.reset();
  for (const glm::vec2 way : {glm::vec2(1, 0), glm::vec2(0, 1), glm::vec2(-0.6, 0.8)}) {
    state.tool = EdgePlace{glm::vec2(320, 180) + 150.0F * way, way, "the tip"};
    const person::Sight sight = seen(state);
    ASSERT_TRUE(sight.lost && sight.ring && !sight.touch) << way.x;
    EXPECT_GT(sight.lost->x * way.x + sight.lost->y * way.y, 0.95) << way.x;
  }
}

TEST_F(PersonSightTest, SeesThatTheToolIsInAndThatNothingIsLeft) {
  OverlayState state = on_the_way();
  state.target->dwelling = true;
  state.target->progress = 0.6F;
  const person::Sight in = seen(state);
  ASSERT_TRUE(in.ring);
  EXPECT_TRUE(in.ring->filling);
  expect_near(in.ring->middle, state.target->at.place, 2.5);
  state.target.reset();
  for (CheckpointLine& line : state.checkpoints) line.state.show = render::MarkerState::Show::done;
  const person::Sight over = seen(state);
  EXPECT_FALSE(over.ring || over.touch);
  EXPECT_EQ(over.done, 2);
}

}  // namespace
}  // namespace fulcrum::ui
