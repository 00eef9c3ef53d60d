#include "engine/render/mip_chain.h"

#include <gtest/gtest.h>

namespace fulcrum::render {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(MipChain, HalvesDownToOnePixel) {
  const Texture texture{"odd", 5, 3, Bytes(5 * 3 * 4, 77), false};
  const auto levels = mip_chain(texture);
  ASSERT_EQ(levels.size(), 3U);
  EXPECT_EQ(levels[1].size(), 4U * 2 * 1);
  EXPECT_EQ(levels[2], Bytes(4, 77));
  EXPECT_EQ(mip_levels(texture), 3U);
  EXPECT_EQ(mip_bytes(texture), 4U * (15 + 2 + 1));
}

// Half the light of white is 188 in sRGB (IEC 61966-2-1), and 128 as a number.
TEST(MipChain, TakesTheMeanOfLight) {
  const Bytes checks{0, 0, 0, 255, 255, 255, 255, 255, 255, 255, 255, 255, 0, 0, 0, 255};
  EXPECT_EQ(mip_chain({"checks", 2, 2, checks, true})[1], (Bytes{188, 188, 188, 255}));
  EXPECT_EQ(mip_chain({"checks", 2, 2, checks, false})[1], (Bytes{128, 128, 128, 255}));
  EXPECT_FLOAT_EQ(mean_colour({"checks", 2, 2, checks, true}).g, 0.5F);
}

TEST(MipChain, WhatIsNotThereHasNoColour) {
  const Bytes half{0, 255, 0, 0, 200, 10, 10, 255};
  EXPECT_EQ(mip_chain({"half", 2, 1, half, true, true})[1], (Bytes{200, 10, 10, 128}));
  EXPECT_NEAR(mean_colour({"half", 2, 1, half, true, true}).r, 0.578F, 0.001F) << "200 in sRGB";
  // Where nothing is there at all, what lies beside it is not mixed with black.
  const Bytes none{200, 100, 50, 0, 200, 100, 50, 0};
  EXPECT_EQ(mip_chain({"none", 2, 1, none, true, true})[1], (Bytes{200, 100, 50, 0}));
}

// A sampler mixes it with what is there, and must not bring a colour that nobody sees.
TEST(MipChain, BesideWhatIsThereNothingHasItsColour) {
  Bytes dots;
  for (int i = 0; i < 8; ++i) dots.insert(dots.end(), {0, 255, 0, 0});
  dots[8] = 200, dots[9] = 10, dots[10] = 10, dots[11] = 255;  // the third
  EXPECT_EQ(mip_chain({"dots", 8, 1, dots, false, true})[1],
            (Bytes{200, 10, 10, 0, 200, 10, 10, 128, 200, 10, 10, 0, 0, 255, 0, 0}));
}

// Where alpha is cut off at 0.5, half of this is there, however little alpha there is in the mean.
TEST(MipChain, OfHolesAlphaIsThePartThatIsThere) {
  const Bytes wires{200, 10, 10, 130, 0, 255, 0, 0};
  const auto levels = mip_chain({"wires", 2, 1, wires, true, true, 0.5F});
  EXPECT_EQ(levels[0], (Bytes{200, 10, 10, 148, 0, 255, 0, 0})) << "as high above the half, eight times";
  EXPECT_EQ(levels[1], (Bytes{200, 10, 10, 128}));
  EXPECT_EQ(mip_chain({"wires", 2, 1, wires, true, true, 0.6F})[1][3], 0);
  EXPECT_EQ(mip_chain({"all", 1, 1, {9, 9, 9, 255}, true, true, 1.0F})[0][3], 128) << "just there";
}

// An alpha that means nothing weighs nothing.
TEST(MipChain, WithoutHolesAlphaIsANumberLikeOthers) {
  const Bytes pixels{200, 100, 50, 0, 200, 100, 50, 255};
  EXPECT_EQ(mip_chain({"opaque", 2, 1, pixels, true})[1], (Bytes{200, 100, 50, 128}));
}

// Two normals that lean 0.6 to either side: their mean leans nowhere, and they do 0.6 in the root mean
// square.
TEST(ReliefChain, KeepsHowFarNormalsAreSpread) {
  const Bytes ridge{204, 128, 230, 255, 51, 128, 230, 255};
  const auto levels = relief_chain({"ridge", 2, 1, ridge, false});
  EXPECT_EQ(levels[0], (Bytes{204, 128, 230, 0, 51, 128, 230, 0})) << "what is seen one by one is not spread";
  EXPECT_EQ(levels[1], (Bytes{128, 128, 230, 153}));
  const Bytes slope{204, 128, 230, 255, 204, 128, 230, 255};
  EXPECT_EQ(relief_chain({"slope", 2, 1, slope, false})[1], (Bytes{204, 128, 230, 0}));
}

// Each level has the light of the whole, whatever the sides.
TEST(MipChain, KeepsTheMean) {
  Texture texture{"noise", 64, 32, {}, false};
  std::uint32_t state = 1;
  double sum = 0;
  for (int i = 0; i < 64 * 32 * 4; ++i) {
    state = 1664525 * state + 1013904223;
    texture.rgba.push_back(static_cast<std::uint8_t>(state >> 24));
    sum += texture.rgba.back();
  }
  for (const Bytes& level : mip_chain(texture)) {
    double mean = 0;
    for (const std::uint8_t byte : level) mean += byte;
    EXPECT_NEAR(mean / static_cast<double>(level.size()), sum / (64 * 32 * 4), 0.6);
  }
}

}  // namespace
}  // namespace fulcrum::render
