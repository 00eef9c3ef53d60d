// What a gamepad's buttons ask for, before a stop, in one and after the end.

#include "engine/app/window/pad_controls.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/app/window/pad_device.h"
#include "engine/ui/pads.h"

namespace fulcrum::app::test {
namespace {

using Actions = std::vector<PadAction>;

TEST(PadControls, BAndStartStopAndAGoesOn) {
  for (const PadPhase phase : {PadPhase::running, PadPhase::stopped}) {
    EXPECT_EQ(pad_actions(ui::kPadB, phase), Actions{PadAction::stop});
    EXPECT_EQ(pad_actions(ui::kPadStart, phase), Actions{PadAction::stop});
    EXPECT_EQ(pad_actions(ui::kPadA, phase), Actions{PadAction::go_on});
  }
}

TEST(PadControls, NoSlipOfAThumbThrowsARunningTrialAway) {
  EXPECT_TRUE(pad_actions(ui::kPadY | ui::kPadBack, PadPhase::running).empty());
  for (const PadPhase phase : {PadPhase::stopped, PadPhase::ended}) {
    EXPECT_EQ(pad_actions(ui::kPadY, phase), Actions{PadAction::restart});
    EXPECT_EQ(pad_actions(ui::kPadBack, phase), Actions{PadAction::start_page});
  }
}

TEST(PadControls, AfterTheEndTheyLookBackAndStopNothing) {
  EXPECT_EQ(pad_actions(ui::kPadLeft, PadPhase::ended), Actions{PadAction::look_back});
  EXPECT_EQ(pad_actions(ui::kPadRight, PadPhase::ended), Actions{PadAction::look_on});
  EXPECT_EQ(pad_actions(ui::kPadLeftBumper, PadPhase::ended), Actions{PadAction::event_before});
  EXPECT_EQ(pad_actions(ui::kPadRightBumper, PadPhase::ended), Actions{PadAction::event_after});
  EXPECT_EQ(pad_actions(ui::kPadA, PadPhase::ended), Actions{PadAction::card});
  EXPECT_TRUE(pad_actions(ui::kPadB | ui::kPadStart, PadPhase::ended).empty());
  EXPECT_TRUE(pad_actions(ui::kPadLeftBumper, PadPhase::running).empty()) << "it rolls the tool then";
}

// Each button that does something is named in the list, and no more than a row of it would tell.
TEST(PadControls, TheListNamesWhatListens) {
  for (const PadPhase phase : {PadPhase::running, PadPhase::stopped, PadPhase::ended}) {
    std::string all;
    for (const ui::KeyLine& line : pad_lines(phase, true, true)) all += line.key + ": " + line.meaning + "\n";
    for (const char* name : {"A", "X", "Y", "Back", "ross"})
      EXPECT_NE(all.find(name), std::string::npos) << name << " in " << all;
    EXPECT_EQ(all.find("Start") != std::string::npos, phase != PadPhase::ended) << all;
  }
  for (const ui::KeyLine& line : pad_lines(PadPhase::stopped, true, false))
    EXPECT_EQ(line.key.find("Back"), std::string::npos) << "there is no start page to go back to";
}

TEST(PadDevice, TakesNoneThatHasADriverOfItsOwnAndKeepsToOneMake) {
  const ui::PadState dualsense{.guid = "sony", .vendor = 0x054c, .product = 0x0ce6, .left_x = 1};
  const ui::PadState xbox{.guid = "xbox", .vendor = 0x045e, .product = 0x028e, .left_x = -1};
  const ui::PadState other{.guid = "other", .vendor = 0x2dc8, .product = 0x6001, .left_x = 1};
  PadDevice pad;
  EXPECT_FALSE(pad.read(std::vector{dualsense}));
  const auto axes = pad.read(std::vector{dualsense, xbox, other});
  ASSERT_TRUE(axes);
  EXPECT_EQ(axes->way.x(), -1);
  EXPECT_FALSE(pad.read(std::vector{other})) << "the run's own is gone";
  EXPECT_TRUE(pad.read(std::vector{other, xbox})) << "it is back";
}

TEST(Pads, AMenuTakesTheStickForTheCross) {
  const auto down = [](double x, double y) {
    return ui::menu_buttons(std::vector{ui::PadState{.left_x = x, .left_y = y}});
  };
  EXPECT_EQ(down(0, 0), 0U);
  EXPECT_EQ(down(0.3, -0.3), 0U);
  EXPECT_EQ(down(0, 0.9), ui::kPadUp);
  EXPECT_EQ(down(0, -0.9), ui::kPadDown);
  EXPECT_EQ(down(-0.9, 0), ui::kPadLeft);
  EXPECT_EQ(down(0.9, 0), ui::kPadRight);
}

}  // namespace
}  // namespace fulcrum::app::test
