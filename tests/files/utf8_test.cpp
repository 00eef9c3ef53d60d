// Which bytes are UTF-8, by RFC 3629's own bounds.

#include "engine/files/utf8.h"

#include <gtest/gtest.h>

#include <string>

namespace fulcrum {
namespace {

TEST(Utf8, WhatIs) {
  for (const std::string_view text :
       {"", "plain", "\xc2\x80", "\xdf\xbf", "\xe0\xa0\x80", "\xed\x9f\xbf", "\xee\x80\x80", "\xef\xbf\xbf",
        "\xf0\x90\x80\x80", "\xf4\x8f\xbf\xbf", "\xc3\xbc ber \xe2\x82\xac"})
    EXPECT_EQ(utf8_bytes(text), text.size()) << text;
}

TEST(Utf8, WhatIsNotEndsThere) {
  const std::string before = "gr\xc3\xbc\xc3\x9f";
  for (const std::string_view bad :
       {"\x80", "\xbf", "\xff", "\xc0\xaf", "\xc1\xbf", "\xe0\x9f\xbf", "\xed\xa0\x80", "\xf0\x8f\xbf\xbf",
        "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xc3", "\xe2\x82", "\xf0\x9f\x98", "\xc3(", "\xe2(\xa1",
        "\xe2\x82("})
    EXPECT_EQ(utf8_bytes(before + std::string(bad) + "x"), before.size()) << before + std::string(bad);
}

}  // namespace
}  // namespace fulcrum
