// Text and gauges over a picture.

#include "engine/ui/overlay.h"

#include <gtest/gtest.h>

#include <utility>

#include "engine/ui/cue_panel.h"
#include "engine/ui/holding_panel.h"
#include "engine/ui/peak_hold.h"
#include "image_compare.h"
#include "overlay_fixture.h"
#include "overlay_parts.h"

namespace fulcrum::ui {
namespace {

TEST_F(OverlayTest, DrawsTheSameTwice) {
  const render::Picture first = draw(full_state());
  const render::Picture second = draw(full_state());
  EXPECT_TRUE(test::compare(first, second, {.max_lsb = 0, .max_pixels = 0, .failure_folder = {}}).passed);
}

// As a window does: a card first, and the scene's own renderer afterwards.
TEST_F(OverlayTest, IsShownByOneRendererAfterAnother) {
  const render::Picture first = draw(full_state());
  renderer_ = std::move(*render::Renderer::create(*gpu_.device, {}, options_));
  const render::Picture second = draw(full_state());
  EXPECT_TRUE(test::compare(first, second, {.max_lsb = 0, .max_pixels = 0, .failure_folder = {}}).passed);
}

TEST_F(OverlayTest, AStopIsARedBandFromEdgeToEdge) {
  OverlayState state = full_state();
  state.force = Force::stopped;
  state.stop_reason = "Esc pressed";
  const render::Picture picture = draw(state);
  for (const float x : {0.01F, 0.97F}) {
    const glm::vec3 band = test::mean(picture, x, 0.26F, x + 0.02F, 0.34F);
    EXPECT_GT(band.r, 150.0F);
    EXPECT_LT(band.g, 70.0F);
  }
}

TEST_F(OverlayTest, ABusyCardShowsHowFarItIsAndNothingElse) {
  const auto busy = [](double fraction) {
    OverlayState state = full_state();
    state.busy = Busy{"Piping", "Baking the distance field", fraction, "Once only."};
    return state;
  };
  const auto blue = [this](const OverlayState& state, float x) {  // of the bar, there
    const glm::vec3 at = test::mean(draw(state), x, 0.535F, x + 0.02F, 0.543F);
    return at.b - at.r;
  };
  EXPECT_GT(blue(busy(0.5), 0.35F), 100.0F);
  EXPECT_LT(blue(busy(0.5), 0.6F), 40.0F);
  EXPECT_GT(blue(busy(0.9), 0.6F), 100.0F);
  const glm::vec3 dials = test::mean(draw(busy(0.5)), 0.05F, 0.85F, 0.15F, 0.95F);
  const glm::vec3 nothing = test::mean(draw({}), 0.05F, 0.85F, 0.15F, 0.95F);
  EXPECT_NEAR(glm::length(dials - nothing), 0.0F, 1.0F);
}

TEST_F(OverlayTest, TheKeyListShowsOnlyWhenAskedFor) {
  OverlayState state = full_state();
  const glm::vec3 without = test::mean(draw(state), 0.4F, 0.4F, 0.6F, 0.6F);
  state.keys_visible = true;
  const glm::vec3 with = test::mean(draw(state), 0.4F, 0.4F, 0.6F, 0.6F);
  EXPECT_LT(with.g, without.g - 10.0F);
}

// A card is darker than what is behind it. One line takes its place at the bottom, a second one the place
// above.
TEST_F(OverlayTest, EachSentenceOfAMessageBeginsALine) {
  OverlayState state = full_state();
  const auto lines = [&](const std::string& message) {
    state.message = message;
    const render::Picture picture = draw(state);
    return std::pair(test::mean(picture, 0.52F, 0.90F, 0.60F, 0.95F).g,
                     test::mean(picture, 0.52F, 0.858F, 0.60F, 0.880F).g);
  };
  const std::string words = "Bring the tip into the hoop: drag it there.";
  const auto none = lines(""), one = lines(words), two = lines(words + '\n' + words);
  EXPECT_LT(one.first, none.first - 10.0F);
  EXPECT_NEAR(one.second, none.second, 1.0F);
  EXPECT_LT(two.first, none.first - 10.0F);
  EXPECT_LT(two.second, none.second - 10.0F);
}

TEST_F(OverlayTest, ADeviceWithoutTorqueHasNoTorqueDial) {
  OverlayState state = full_state();
  state.message.clear();
  const float with = test::mean(draw(state), 0.20F, 0.75F, 0.30F, 0.95F).g;
  state.torque_Nm = {};
  const float without = test::mean(draw(state), 0.20F, 0.75F, 0.30F, 0.95F).g;
  EXPECT_GT(without, with + 10.0F);
}

TEST_F(OverlayTest, APressMeansWhatIsDrawnThere) {
  OverlayState state = full_state();
  state.keys_visible = false;
  state.message.clear();
  state.cues = {{"Torque substitution", "Vibration", "V", 1.0, 0.0},
                {"Torque substitution", "Ghost", "G", 0.0, 0.0}};
  const std::vector<double> gains{1.0, 0.6};
  const render::Picture picture = draw(state);
  const float unit = overlay_scale(picture.height);
  const float width = static_cast<float>(picture.width) / unit,
              height = static_cast<float>(picture.height) / unit;
  // The switch that is on is drawn in the accent's blue: a press there, and only near it, switches off.
  std::size_t blue = 0, off = 0;
  for (float y = 0; y < height; y += 2.0F) {
    for (float x = 0.75F * width; x < width; x += 2.0F) {
      const glm::vec3 colour =
          test::mean(picture, x / width, y / height, (x + 1.5F) / width, (y + 1.5F) / height);
      const bool is_switch = colour.b > 200.0F && colour.r < 120.0F;
      const std::optional<CuePress> press = pressed_cue(state, gains, {width, height, x, y});
      blue += is_switch;
      off += is_switch && press && press->cue == 0 && press->gain == 0.0;
    }
  }
  EXPECT_GT(blue, 20U);
  EXPECT_EQ(off, blue);
}

// Over the panel: what a press there means is what is drawn there.
TEST_F(OverlayTest, TheSliderIsTakenWhereItIsDrawn) {
  OverlayState state = full_state();
  state.holding = held_stick();
  state.holding->measured = false;  // else its switch is blue too
  state.holding->methods.clear();
  state.holding->stiffness.reset();
  const render::Picture picture = draw(state);
  const float unit = overlay_scale(picture.height);
  const float width = static_cast<float>(picture.width) / unit,
              height = static_cast<float>(picture.height) / unit;
  std::size_t blue = 0, on_slider = 0;
  for (float y = 0; y < height; y += 1.0F) {
    for (float x = 0.75F * width; x < width; x += 1.0F) {
      const glm::vec3 colour =
          test::mean(picture, x / width, y / height, (x + 1.0F) / width, (y + 1.0F) / height);
      if (!(colour.b > 200.0F && colour.r < 120.0F)) continue;
      ++blue;
      const std::optional<HoldingPress> press = pressed_holding(state, {width, height, x, y});
      on_slider += press && press->part == HoldingPress::Part::place && std::abs(press->value - 0.1) < 0.008;
    }
  }
  EXPECT_GT(blue, 40U);
  EXPECT_EQ(on_slider, blue);
}

TEST_F(OverlayTest, AStiffnessNearTheLeversLimitIsWarnedOf) {
  const auto drawn = [&](double limit) {
    OverlayState state = full_state();
    state.holding = held_stick();
    state.holding->limit = limit;
    const render::Picture picture = draw(state);
    const float unit = overlay_scale(picture.height);
    const float width = static_cast<float>(picture.width) / unit,
                height = static_cast<float>(picture.height) / unit;
    // Of the scale, a little left of its filled part's end: found by what presses there mean.
    for (float y = 0; y < 400.0F; y += 1.0F) {
      for (float x = 0.7F * width; x < width; x += 1.0F) {
        const auto press = pressed_holding(state, {width, height, x, y});
        if (!press || press->part != HoldingPress::Part::stiffness || press->value != 300.0) continue;
        return test::mean(picture, (x - 4.0F) / width, (y + 9.0F) / height, (x - 1.0F) / width,
                          (y + 11.0F) / height);
      }
    }
    ADD_FAILURE() << "no press sets the stiffness";
    return glm::vec3(0.0F);
  };
  const glm::vec3 calm = drawn(1000), warned = drawn(360), beyond = drawn(250);
  EXPECT_GT(calm.b, calm.r + 40.0F);
  EXPECT_GT(warned.r, warned.b + 60.0F);
  EXPECT_GT(warned.g, beyond.g + 20.0F);
  EXPECT_GT(beyond.r, beyond.g + 60.0F);
}

// Where nothing is drawn of a stiffness nothing sets one, and the methods are taken where they moved up to.
TEST(HoldingPanel, WithoutAStiffnessTheMethodsMoveUp) {
  OverlayState state;
  state.holding = held_stick();
  const auto methods_from = [&state] {
    for (float y = 0; y < 500.0F; y += 1.0F) {
      const auto press = pressed_holding(state, {1280.0F, 720.0F, 1155.0F, y});
      if (press && press->part == HoldingPress::Part::method) return y;
    }
    return -1.0F;
  };
  const auto sets_stiffness = [&state] {
    for (float y = 0; y < 500.0F; y += 1.0F) {
      const auto press = pressed_holding(state, {1280.0F, 720.0F, 1155.0F, y});
      if (press && press->part == HoldingPress::Part::stiffness) return true;
    }
    return false;
  };
  EXPECT_TRUE(sets_stiffness());
  const float with = methods_from();
  state.holding->stiffness.reset();
  EXPECT_FALSE(sets_stiffness());
  EXPECT_GT(methods_from(), 0.0F);
  EXPECT_LT(methods_from(), with - 50.0F);
}

TEST(CuePanel, SwitchesOnAtTheGainOfBeforeAndTheBarSetsIt) {
  OverlayState state;
  state.cues = {{"Torque substitution", "Vibration", "V", 0.0, 0.0},
                {"Torque substitution", "Ghost", "G", 1.0, 0.0}};
  const std::vector<double> gains{0.7, 0.6};
  std::vector<double> set;  // by presses down the middle of the panel, first cue only
  for (float y = 0; y < 300.0F; y += 1.0F)
    if (const auto press = pressed_cue(state, gains, {1280.0F, 720.0F, 1155.0F, y}); press && press->cue == 0)
      set.push_back(press->gain);
  ASSERT_FALSE(set.empty());
  EXPECT_EQ(set.front(), 0.7);
  EXPECT_NEAR(set.back(), 0.5, 0.01);
  EXPECT_FALSE(pressed_cue(state, gains, {1280.0F, 720.0F, 600.0F, 120.0F}));
  state.cues.clear();
  EXPECT_FALSE(pressed_cue(state, {}, {1280.0F, 720.0F, 1155.0F, 120.0F}));
}

TEST_F(OverlayTest, FaultsAreCountedBelowTheCheckpointsAndWarn) {
  OverlayState state = full_state();
  const auto corner = [&] { return test::mean(draw(state), 0.0F, 0.0F, 0.4F, 0.6F); };
  const float without = corner().g;
  state.faults = {{"Hard touches", 0}};
  const glm::vec3 none = corner();
  EXPECT_LT(none.g, without - 0.5F);  // the card is longer
  state.faults.front().count = 3;
  const glm::vec3 some = corner();
  EXPECT_GT(some.r - some.b, none.r - none.b + 0.2F);  // and the line yellow
  state.faults.push_back({"Slips", 0});
  EXPECT_LT(corner().g, some.g - 0.3F);  // longer still
}

// A bar on its side of the middle, in the colour of its load, and marks of what has been.
TEST_F(OverlayTest, MotorsAreBarsToEitherSideOfTheMiddle) {
  OverlayState state = full_state();
  // Theme units from the panel's right and bottom edges to the only row.
  const auto side = [&](float from_x, float to_x) {
    const render::Picture picture = draw(state);
    const float unit = overlay_scale(picture.height);
    const float width = static_cast<float>(picture.width) / unit,
                height = static_cast<float>(picture.height) / unit;
    const float middle = width - 18.0F - 14.0F - 42.0F, y = height - 18.0F - 6.0F - 9.5F;
    return test::mean(picture, (middle + from_x) / width, (y - 2.0F) / height, (middle + to_x) / width,
                      (y + 2.0F) / height);
  };
  const glm::vec3 nothing = side(5.0F, 15.0F);
  state.motors = {{"lower yaw", 0.5, 0.0, 0.5}};
  EXPECT_GT(side(5.0F, 15.0F).b, nothing.b + 60.0F);    // calm, and blue
  EXPECT_LT(side(-15.0F, -5.0F).b, nothing.b + 20.0F);  // nothing on the other side
  EXPECT_LT(side(25.0F, 35.0F).b, nothing.b + 20.0F);   // nor beyond the load
  state.motors = {{"lower yaw", -0.95, -0.95, 0.0}};
  const glm::vec3 at_limit = side(-35.0F, -5.0F);
  EXPECT_GT(at_limit.r, at_limit.b + 80.0F);
  EXPECT_LT(side(5.0F, 15.0F).r, nothing.r + 20.0F);
  state.motors = {{"lower yaw", 0.0, 0.0, 1.0}};  // a tick ago
  const glm::vec3 held = side(5.0F, 35.0F);
  EXPECT_GT(held.r, held.b + 30.0F);
  EXPECT_LT(held.r, at_limit.r - 40.0F);
}

TEST_F(OverlayTest, FollowsThePictureToAnotherSize) {
  draw(full_state());
  ASSERT_FALSE(renderer_->resize({1280, 720}));
  EXPECT_EQ(draw(full_state()).width, 1280U);
  ASSERT_FALSE(renderer_->resize({200, 100}));
  draw(full_state());
}

TEST(PeakHold, HoldsThenFallsToTheValue) {
  PeakHold peak;
  EXPECT_DOUBLE_EQ(peak.add(2.0, 0.0), 2.0);
  EXPECT_DOUBLE_EQ(peak.add(1.0, 1.0), 2.0);
  double last = 2.0;
  for (int i = 0; i < 100; ++i) last = peak.add(1.0, 1.6 + 0.05 * i);
  EXPECT_DOUBLE_EQ(last, 1.0);
  EXPECT_DOUBLE_EQ(peak.add(0.5, 0.0), 0.5);  // a run that starts again
}

}  // namespace
}  // namespace fulcrum::ui
