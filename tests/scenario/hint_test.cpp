#include "engine/scenario/hint.h"

#include <gtest/gtest.h>

namespace fulcrum::scenario {
namespace {

constexpr std::array<std::string_view, 5> kSaid{"drag", "roll", "with Shift", "press Esc", "press Enter"};

TEST(Hint, SaysWhatTheDeviceDoes) {
  EXPECT_EQ(hint_text("Go there: {move}.", kSaid), "Go there: drag.");
  EXPECT_EQ(hint_text("{turn}, {finely}; {stop} and {go_on}", kSaid),
            "roll, with Shift; press Esc and press Enter");
  EXPECT_EQ(hint_text("No word of a device.", kSaid), "No word of a device.");
  EXPECT_EQ(hint_text("", kSaid), "");
}

TEST(Hint, IsRefusedWithAWordThatNoDeviceHas) {
  EXPECT_EQ(hint_fault("Go there: {move}, then {turn}."), "");
  EXPECT_EQ(hint_fault("Go there: {mvoe}."), "has the word '{mvoe}'; did you mean 'move'?");
  EXPECT_NE(hint_fault("Go there: {}."), "");
  EXPECT_NE(hint_fault("Go there: {sing}.").find("move, turn, finely, stop, go_on"), std::string::npos);
}

TEST(Hint, IsRefusedWithABraceAlone) {
  for (const char* const hint : {"{move", "move}", "{move {turn}", "{move}}", "}{", "{"})
    EXPECT_NE(hint_fault(hint).find("a brace without its other"), std::string::npos) << hint;
}

// Letters, not bytes.
TEST(Hint, HasALengthThatFitsALine) {
  std::string hint;
  for (std::size_t i = 0; i < kHintLetters; ++i) hint += "\u00e9";
  EXPECT_EQ(hint_fault(hint), "");
  EXPECT_EQ(hint_fault(hint + "e"), "has 111 letters; it is one line of 110 at most");
}

}  // namespace
}  // namespace fulcrum::scenario
