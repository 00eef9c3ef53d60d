#include "engine/files/plain_text.h"

#include <gtest/gtest.h>

namespace fulcrum {
namespace {

TEST(PlainText, LeavesWhatIsShown) {
  const std::string text = "a \xc3\xa9 \xe2\x82\xac \xf0\x9f\x94\xa9 ~\xe2\x80\x8d";
  EXPECT_EQ(plain_text(text), text);
  EXPECT_EQ(plain_text(""), "");
}

TEST(PlainText, HasNothingThatATerminalObeys) {
  EXPECT_EQ(plain_text("a\x1b[2J\nb\x7f"
                       "c\xc2\x9b"
                       "d"),
            "a [2J b c d");
  // In halves: a compiler's warnings look for such characters in the source.
  const std::string turn = "\xe2\x80", isolate = "\xe2\x81";
  EXPECT_EQ(plain_text(turn + "\xae" + "left" + turn + "\xa8" + "line" + isolate + "\xa6"), " left line ");
}

TEST(PlainText, IsAlwaysUtf8) {
  const std::string odd = "\xef\xbf\xbd";
  EXPECT_EQ(plain_text("\xff"
                       "a\xe2\x82"),
            odd + "a" + odd + odd);
  EXPECT_EQ(plain_text("\xc2"), odd);
}

TEST(PlainText, IsCutBetweenCharacters) {
  EXPECT_EQ(short_text("abc", 3), "abc");
  EXPECT_EQ(short_text("abcd", 3), "abc...");
  EXPECT_EQ(short_text("ab\xe2\x82\xac", 5), "ab\xe2\x82\xac");
  EXPECT_EQ(short_text("\xff\xff\xff", 3), "\xef\xbf\xbd...");
}

}  // namespace
}  // namespace fulcrum
