#include "engine/assets/hdr.h"

#include <gtest/gtest.h>

#include <random>
#include <string_view>

#include "tests/assets/hdr_of.h"

namespace fulcrum {
namespace {

using test::HdrRows;
using test::Rgb;
using Bytes = std::vector<std::uint8_t>;

// Of numbers that eight bits hold, from a thousandth to a million.
Rgb some(std::uint32_t x, std::uint32_t y) {
  const float scale = std::ldexp(1.0F, static_cast<int>(x) * 2 - 10);
  return {scale, y == 0 ? 0.0F : scale * 0.5F, x % 3 == 0 ? scale * 0.75F : 0.0F};
}

std::string refusal_of(const Bytes& bytes) {
  const Result<HdrPicture> picture = decode_hdr(bytes);
  return picture ? "" : picture.error().sentence;
}

Bytes bytes_of(std::string_view text) {
  return {text.begin(), text.end()};
}

TEST(DecodeHdr, GivesTheRadianceOfEachPixel) {
  for (const HdrRows rows : {HdrRows::flat, HdrRows::in_runs}) {
    const Result<HdrPicture> picture = decode_hdr(test::hdr_of(16, 8, rows, some));
    ASSERT_TRUE(picture) << picture.error().sentence;
    EXPECT_EQ(picture->width, 16U);
    EXPECT_EQ(picture->height, 8U);
    ASSERT_EQ(picture->pixels.size(), 128U);
    for (std::uint32_t y = 0; y < 8; ++y)
      for (std::uint32_t x = 0; x < 16; ++x)
        EXPECT_EQ(picture->pixels[16 * y + x], some(x, y)) << x << " " << y;
  }
}

// "Radiance File Formats": the numbers have been multiplied by all exposures of the header.
TEST(DecodeHdr, ExposuresAreTakenOut) {
  const auto even = [](std::uint32_t, std::uint32_t) { return Rgb{4, 2, 1}; };
  const auto picture = decode_hdr(test::hdr_of(
      2, 1, HdrRows::flat, even, "SOFTWARE=a test\nEXPOSURE=4\nEXPOSURE= 0.5\nFORMAT=32-bit_rle_rgbe\n"));
  ASSERT_TRUE(picture) << picture.error().sentence;
  EXPECT_EQ(picture->pixels[1], (Rgb{2, 1, 0.5F}));
  const auto written = decode_hdr(test::hdr_of(
      2, 1, HdrRows::flat, even, "FORMAT= 32-bit_rle_rgbe \nEXPOSURE=\t+2\nCOLORCORR= 1 0.5 2\n"));
  ASSERT_TRUE(written) << written.error().sentence;
  EXPECT_EQ(written->pixels[1], (Rgb{2, 2, 0.25F}));
}

// Those of the first version of the format: (1, 1, 1, n), and more digits after it.
TEST(DecodeHdr, OldRunsRepeatTheLastPixel) {
  Bytes bytes = bytes_of("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n\n-Y 300 +X 600\n");
  for (int row = 0; row < 300; ++row) {
    const auto first = test::rgbe_of({1, 2, 3}), last = test::rgbe_of({4, 0, 0});
    bytes.insert(bytes.end(), first.begin(), first.end());
    bytes.insert(bytes.end(), {1, 1, 1, 598 - 512, 1, 1, 1, 2});
    bytes.insert(bytes.end(), last.begin(), last.end());
  }
  const auto picture = decode_hdr(bytes);
  ASSERT_TRUE(picture) << picture.error().sentence;
  for (std::size_t i = 0; i < picture->pixels.size(); ++i)
    ASSERT_EQ(picture->pixels[i], i % 600 == 599 ? (Rgb{4, 0, 0}) : (Rgb{1, 2, 3})) << i;
}

TEST(DecodeHdr, SaysWhatIsWrongAndWhatToDo) {
  const auto bright = [](std::uint32_t, std::uint32_t) { return Rgb{1e12F, 0, 0}; };
  const auto header = [](std::string_view rest) {
    return bytes_of(std::string("#?RADIANCE\nFORMAT=32-bit_rle_rgbe\n").append(rest));
  };
  const std::pair<Bytes, const char*> kCases[] = {
      {{}, "its header does not end"},
      {bytes_of("\x89PNG\r\n\x1a\n"), "no Radiance picture"},
      {bytes_of("#?RADIANCE\nFORMAT=32-bit_rle_xyze\n\n-Y 1 +X 2\n"), "not red, green and blue"},
      {bytes_of("#?RADIANCE\nEXPOSURE=0\n\n-Y 1 +X 2\n"), "exposure"},
      {bytes_of("#?RADIANCE\nEXPOSURE=nan\n\n-Y 1 +X 2\n"), "exposure"},
      {header("\n+Y 1 +X 2\n"), "do not go from the top"},
      {header("\n+X 2 -Y 1\n"), "do not go from the top"},
      {header("\n-Y 1 +X 99999999999\n"), "its size cannot be read"},
      {header("EXPOSURE=1e30\nEXPOSURE=1e30\n\n-Y 1 +X 2\n"), "exposures together are out of all bounds"},
      {header("EXPOSURE=1e-30\nEXPOSURE=1e-30\n\n-Y 1 +X 2\n"), "exposures together are out of all bounds"},
      {header("COLORCORR=1 2\n\n-Y 1 +X 2\n"), "its exposure is no number above 0"},
      {bytes_of("#?RADIANCE\r\n"), "its lines end as on Windows"},
      {header("\n-Y 4096 +X 8192\n"), "it is 8192 x 4096 pixels: make it smaller, at most 4096 x 2048"},
      {header("\n-Y 0 +X 0\n"), "it has no pixels"},
      {header("\n-Y 6 +X 8\n"), "twice as wide as high"},
      {header("\n-Y 4 +X 8\n\x02\x02"), "ends too early"},
      {header(std::string_view("\n-Y 4 +X 8\n\x02\x02\x00\x09", 15)), "a row has another length"},
      {header(std::string_view("\n-Y 4 +X 8\n\x02\x02\x00\x08\x89\x01", 17)), "a run is longer than its row"},
      {header(std::string_view("\n-Y 4 +X 8\n\x02\x02\x00\x08\x00\x01", 17)), "a run is longer than its row"},
      {header(std::string_view("\n-Y 1 +X 2\n\x01\x01\x01\x01", 15)), "a run is longer than its row"},
      {test::hdr_of(2, 1, HdrRows::flat, bright), "brighter than any lamp"},
  };
  for (const auto& [bytes, said] : kCases)
    EXPECT_NE(refusal_of(bytes).find(said), std::string::npos) << said << ": " << refusal_of(bytes);
}

// Whatever is cut off or changed of a file, it is refused with a clause, or it is a sound picture.
TEST(DecodeHdr, DamagedFilesAreRefusedOrSound) {
  std::mt19937 random(1);
  for (const HdrRows rows : {HdrRows::flat, HdrRows::in_runs}) {
    const Bytes whole = test::hdr_of(16, 8, rows, some);
    for (std::size_t size = 0; size < whole.size(); ++size)
      EXPECT_FALSE(refusal_of({whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(size)}).empty())
          << size;
    int sound = 0;
    for (int i = 0; i < 20000; ++i) {
      Bytes bytes = whole;
      for (int change = 0; change < 3; ++change)
        bytes[random() % bytes.size()] = static_cast<std::uint8_t>(random());
      const Result<HdrPicture> picture = decode_hdr(bytes);
      if (!picture) {
        EXPECT_FALSE(picture.error().sentence.empty());
        continue;
      }
      ++sound;
      ASSERT_EQ(picture->pixels.size(), std::size_t{picture->width} * picture->height);
      for (const Rgb& pixel : picture->pixels)
        for (const float part : pixel) ASSERT_TRUE(part >= 0.0F && part <= kBrightestHdr);
    }
    EXPECT_GT(sound, 100);
    EXPECT_LT(sound, 20000);
  }
}

}  // namespace
}  // namespace fulcrum
