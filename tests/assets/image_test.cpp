#include "engine/assets/image.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <string>

#include "tests/assets/pictures.h"

namespace fulcrum {
namespace {

using Bytes = std::vector<std::uint8_t>;

TEST(DecodeImage, GivesThePixelsOfAPng) {
  const Bytes pixels{255, 0, 0, 255, 0, 255, 0, 128, 10, 20, 30, 0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  const auto image = decode_image(test::png_of(3, 2, PNG_FORMAT_RGBA, pixels));
  ASSERT_TRUE(image) << image.error().sentence;
  EXPECT_EQ(image->width, 3U);
  EXPECT_EQ(image->height, 2U);
  EXPECT_EQ(image->rgba, pixels);
}

TEST(DecodeImage, GreyIsAllThreeAndWithoutAlphaItIsOpaque) {
  EXPECT_EQ(decode_image(test::png_of(2, 1, PNG_FORMAT_GRAY, {7, 200}))->rgba,
            (Bytes{7, 7, 7, 255, 200, 200, 200, 255}));
  EXPECT_EQ(decode_image(test::png_of(1, 1, PNG_FORMAT_RGB, {1, 2, 3}))->rgba, (Bytes{1, 2, 3, 255}));
}

// A file whose numbers are declared as linear light is read as they are, not brightened (glTF 2.0, 3.8.3).
TEST(DecodeImage, WhatAFileSaysOfItsColoursIsIgnored) {
  Bytes png = test::png_of(1, 1, PNG_FORMAT_RGB, {40, 80, 160});
  const Bytes gamma{0, 0, 0, 4, 'g', 'A', 'M', 'A', 0, 1, 0x86, 0xa0, 0x31, 0xe8, 0x96, 0x5f};  // 1.0
  for (const char* other : {"gAMA", "sRGB"}) {  // the writer's own
    if (const auto at = std::string(png.begin(), png.end()).find(other); at != std::string::npos) {
      const std::size_t size = png[at - 1];
      png.erase(png.begin() + static_cast<std::ptrdiff_t>(at) - 4,
                png.begin() + static_cast<std::ptrdiff_t>(at + 8 + size));
    }
  }
  png.insert(png.begin() + 33, gamma.begin(), gamma.end());  // after IHDR
  const auto image = decode_image(png);
  ASSERT_TRUE(image) << image.error().sentence;
  EXPECT_EQ(image->rgba, (Bytes{40, 80, 160, 255}));
}

TEST(DecodeImage, GivesThePixelsOfAJpeg) {
  Bytes pixels;
  for (int i = 0; i < 16 * 8; ++i) pixels.insert(pixels.end(), {200, 100, 50});
  const auto image = decode_image(test::jpeg_of(16, 8, pixels));
  ASSERT_TRUE(image) << image.error().sentence;
  ASSERT_EQ(image->rgba.size(), 16U * 8 * 4);
  for (std::size_t i = 0; i < image->rgba.size(); i += 4) {
    EXPECT_LE(std::abs(image->rgba[i] - 200), 3);
    EXPECT_LE(std::abs(image->rgba[i + 2] - 50), 3);
    EXPECT_EQ(image->rgba[i + 3], 255);
  }
}

// libpng's simplified interface reads interlaced files of 16 bits wrongly.
TEST(DecodeImage, WhatWouldBeReadWronglyIsRefused) {
  Bytes png = test::png_of(1, 1, PNG_FORMAT_RGB, {1, 2, 3});
  png[24] = 16;
  png[28] = 1;
  const auto refused = decode_image(png);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().sentence,
            "it is interlaced, with 16 bits a colour, which is not supported: export it without interlacing");
}

// Cut off anywhere, or one byte wrong: refused with a clause, or decoded to as many pixels as it says.
TEST(DecodeImage, DamagedOnesAreRefusedOrWhole) {
  Bytes noise;
  std::uint32_t state = 7;
  for (int i = 0; i < 24 * 24 * 3; ++i)
    noise.push_back(static_cast<std::uint8_t>((state = 1664525 * state + 1013904223) >> 24));
  for (const Bytes& whole : {test::png_of(24, 24, PNG_FORMAT_RGB, noise), test::jpeg_of(24, 24, noise)}) {
    int refused = 0;
    for (std::size_t i = 0; i < whole.size(); i += 3) {
      Bytes cut(whole.begin(), whole.begin() + static_cast<std::ptrdiff_t>(i));
      Bytes bent = whole;
      bent[i] ^= 0x41;
      for (const Bytes& bytes : {cut, bent}) {
        const auto image = decode_image(bytes);
        if (image) {
          EXPECT_EQ(image->rgba.size(), std::size_t{4} * image->width * image->height);
        } else {
          EXPECT_FALSE(image.error().sentence.empty());
          ++refused;
        }
      }
    }
    EXPECT_GT(refused, static_cast<int>(whole.size() / 3)) << "whatever is cut off";
  }
}

// A file of a few bytes that says it is enormous takes no memory.
TEST(DecodeImage, LargeOnesAreRefusedByTheirSize) {
  Bytes png = test::png_of(1, 1, PNG_FORMAT_RGB, {1, 2, 3});
  png[16 + 2] = 0x27;  // 10 001 wide
  png[16 + 3] = 0x11;
  // Its checksum is wrong now, too: either is a reason.
  EXPECT_FALSE(decode_image(png));
  const Bytes wide(std::size_t{9000} * 3, 0);
  const auto refused = decode_image(test::jpeg_of(9000, 1, wide));
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().sentence, "it is 9000 x 1 pixels: make it smaller, at most 8192 a side");
}

// A first marker, and then nothing that a decoder would call wrong.
TEST(DecodeImage, OneWithoutPixelsIsDamagedAndNotTooLarge) {
  Bytes jpeg(64, 0);
  std::ranges::copy(Bytes{0xff, 0xd8, 0xff, 0xe0}, jpeg.begin());
  const auto refused = decode_image(jpeg);
  ASSERT_FALSE(refused);
  EXPECT_EQ(refused.error().sentence, "it is damaged (it has no pixels); export it again");
}

TEST(IsPicture, KnowsItsTwoKinds) {
  EXPECT_TRUE(is_picture(test::png_of(1, 1, PNG_FORMAT_RGB, {1, 2, 3})));
  EXPECT_TRUE(is_picture(test::jpeg_of(8, 8, Bytes(192, 9))));
  EXPECT_FALSE(is_picture(Bytes{'R', 'I', 'F', 'F', 0, 0, 0, 0, 'W', 'E', 'B', 'P'}));
  EXPECT_FALSE(is_picture(Bytes{}));
}

}  // namespace
}  // namespace fulcrum
