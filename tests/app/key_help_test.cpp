#include "engine/app/window/key_help.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fulcrum::app {
namespace {

std::string meaning(const std::vector<ui::KeyLine>& lines, const std::string& key) {
  const auto line = std::ranges::find(lines, key, &ui::KeyLine::key);
  return line == lines.end() ? "" : line->meaning;
}

TEST(KeyHelp, NamesTheViewsBesideTheirKeys) {
  const std::vector<scenario::View> views{{"overview", {}}, {"down_the_canal", {}}};
  EXPECT_EQ(meaning(key_lines({}, views, false, false), "1 to 2"), "views: 1 overview, 2 down the canal");
  EXPECT_EQ(meaning(key_lines({}, {views.data(), 1}, false, false), "1"), "views: 1 overview");
  EXPECT_EQ(meaning(key_lines({}, {}, false, false), "1"), "");
  const std::vector<scenario::View> many(12, {"v", {}});
  EXPECT_EQ(meaning(key_lines({}, many, false, false), "1 to 9"),
            "views: 1 v, 2 v, 3 v, 4 v, 5 v, 6 v, 7 v, 8 v, 9 v");
}

TEST(KeyHelp, ListsOnlyWhatDoesSomething) {
  ui::OverlayState state;
  EXPECT_EQ(meaning(key_lines(state, {}, false, false), "F2"), "");
  EXPECT_NE(meaning(key_lines(state, {}, false, false), "F3"), "");
  EXPECT_EQ(meaning(key_lines(state, {}, false, false), "F4"), "");
  state.muted = false;
  EXPECT_EQ(meaning(key_lines(state, {}, false, false), "F4"), "sound off");
  state.muted = true;
  EXPECT_EQ(meaning(key_lines(state, {}, false, false), "F4"), "sound on");
  EXPECT_EQ(meaning(key_lines(state, {}, false, false), "C"), "");
  EXPECT_NE(meaning(key_lines(state, {}, true, false), "C"), "");
  EXPECT_EQ(meaning(key_lines(state, {}, false, false), "F10"), "");
  EXPECT_NE(meaning(key_lines(state, {}, false, true), "F10"), "");
  EXPECT_NE(meaning(key_lines(state, {}, false, false), "F6"), "");
  EXPECT_NE(meaning(key_lines(state, {}, false, false), "F7"), "");
  EXPECT_EQ(meaning(key_lines(state, {}, false, false), "F5"), "") << "nothing is looked back at";
  state.timeline.emplace();
  EXPECT_EQ(meaning(key_lines(state, {}, false, false), "F5"), "") << "there is no expert";
  state.timeline->has_expert = true;
  EXPECT_NE(meaning(key_lines(state, {}, false, false), "F5"), "");
  state.checkpoints = {{"there", {}}};
  EXPECT_NE(meaning(key_lines(state, {}, false, false), "F2"), "");
  state.cues = {{"Torque substitution", "Ghost", "G", 1.0, 0.0}};
  EXPECT_EQ(meaning(key_lines(state, {}, false, false), "G"), "switch torque substitution: ghost");
}

}  // namespace
}  // namespace fulcrum::app
