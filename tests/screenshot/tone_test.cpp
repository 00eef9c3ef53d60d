// Pictures of others pass through the same tone mapping as ours.

#include "engine/render/tone.h"

#include <gtest/gtest.h>
#include <png.h>
#include <sys/resource.h>

#include <string>
#include <vector>

#include "engine/render/radiance_png.h"
#include "engine/render/renderer.h"
#include "test_scene.h"

namespace fulcrum::render {
namespace {

Picture background_alone(const Background& background) {
  const test::Gpu gpu = test::make_gpu();
  VisualDesc desc;
  desc.background = background;
  RenderOptions options;
  options.extent = {16, 64};
  options.quality.samples = 1;
  const auto renderer = Renderer::create(*gpu.device, desc, options);
  EXPECT_TRUE(renderer);
  FrameState state;
  EXPECT_FALSE((*renderer)->frame(state));
  return *(*renderer)->read_back();
}

// Within what the shader's noise and eight bits leave open.
TEST(Tone, IsTheShaders) {
  for (const Background& background : {Background{{0.2F, 0.24F, 0.3F}, {0.06F, 0.07F, 0.08F}},
                                       Background{{4.0F, 0.5F, 0.02F}, {0.0F, 0.9F, 8.0F}},
                                       Background{{0.001F, 0.002F, 0.004F}, {20.0F, 20.0F, 20.0F}}}) {
    const Picture picture = background_alone(background);
    for (std::uint32_t y = 0; y < picture.height; ++y) {
      const float v = (static_cast<float>(y) + 0.5F) / static_cast<float>(picture.height);
      const glm::vec3 wanted = 255.0F * tone_mapped(background_radiance(background, v));
      for (std::uint32_t x = 0; x < picture.width; ++x)
        for (int i = 0; i < 3; ++i)
          EXPECT_NEAR(picture.rgba[(y * picture.width + x) * 4 + static_cast<std::uint32_t>(i)], wanted[i],
                      1.6F)
              << y << ", " << i;
    }
  }
}

// A PNG of 16 bits each. values: of its rows, one after the other; the header may promise more of them.
std::string png_of(std::uint32_t width, std::uint32_t height, int format, std::vector<std::uint16_t> values) {
  std::string bytes;
  png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
  png_infop info = png_create_info_struct(png);
  png_set_write_fn(
      png, &bytes,
      [](png_structp to, png_bytep data, std::size_t size) {
        static_cast<std::string*>(png_get_io_ptr(to))->append(reinterpret_cast<const char*>(data), size);
      },
      nullptr);
  png_set_IHDR(png, info, width, height, 16, format, PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT,
               PNG_FILTER_TYPE_DEFAULT);
  png_write_info(png, info);
  png_set_swap(png);
  const std::size_t row = std::size_t{width} * png_get_channels(png, info);
  const std::size_t rows = values.size() / row;
  for (std::size_t y = 0; y < rows; ++y)
    png_write_row(png, reinterpret_cast<png_const_bytep>(values.data() + y * row));
  if (rows == height) png_write_end(png, info);
  png_destroy_write_struct(&png, &info);
  return bytes;
}

TEST(Radiance, IsReadAsItsHeaderSays) {
  // The square root of 0.5 / 1.5 and of 0.25 / 1.5: half and a quarter; then nothing at all.
  const auto radiance =
      read_radiance(png_of(2, 1, PNG_COLOR_TYPE_RGB_ALPHA, {37837, 26755, 0, 65535, 0, 0, 0, 13107}));
  ASSERT_TRUE(radiance) << radiance.error().sentence;
  ASSERT_EQ(radiance->width, 2U);
  ASSERT_EQ(radiance->height, 1U);
  EXPECT_NEAR(radiance->pixels[0].r, 0.5F, 1e-4F);
  EXPECT_NEAR(radiance->pixels[0].g, 0.25F, 1e-4F);
  EXPECT_EQ(radiance->pixels[0].b, 0.0F);
  EXPECT_EQ(radiance->pixels[0].a, 1.0F);
  EXPECT_NEAR(radiance->pixels[1].a, 0.2F, 1e-6F);
}

TEST(Radiance, OfAnotherKindIsRefused) {
  EXPECT_FALSE(read_radiance(""));
  EXPECT_NE(read_radiance(png_of(2, 1, PNG_COLOR_TYPE_RGB, {1, 2, 3, 4, 5, 6}))
                .error()
                .sentence.find("no whole PNG of red, green, blue and alpha"),
            std::string::npos);
  const std::string whole = png_of(2, 1, PNG_COLOR_TYPE_RGB_ALPHA, {1, 2, 3, 4, 5, 6, 7, 8});
  EXPECT_FALSE(read_radiance(whole.substr(0, whole.size() - 20)));
}

TEST(Radiance, LargerThanAReferenceIsRefused) {
  const auto row_of = [](std::uint32_t width) {
    return png_of(width, 1, PNG_COLOR_TYPE_RGB_ALPHA, std::vector<std::uint16_t>(std::size_t{4} * width));
  };
  EXPECT_TRUE(read_radiance(row_of(kMostRadiancePixels)));
  EXPECT_FALSE(read_radiance(row_of(kMostRadiancePixels + 1)));
}

TEST(Radiance, TakesNoMemoryForRowsThatDoNotCome) {
  const auto largest_kB = [] {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return usage.ru_maxrss;
  };
  // A chunk of pixels begins, and the file ends.
  const std::string promise = png_of(kMostRadiancePixels, kMostRadiancePixels, PNG_COLOR_TYPE_RGB_ALPHA, {}) +
                              std::string("\0\0\0\x10IDAT", 8);
  const long before_kB = largest_kB();
  EXPECT_FALSE(read_radiance(promise));
  EXPECT_LT(largest_kB() - before_kB, 64 * 1024) << "of 128 MiB that are promised";
}

}  // namespace
}  // namespace fulcrum::render
