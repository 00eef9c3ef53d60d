// Pictures of others pass through the same tone mapping as ours.

#include "engine/render/tone.h"

#include <gtest/gtest.h>
#include <png.h>
#include <unistd.h>

#include <cstdio>
#include <filesystem>

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

class RadianceFile : public testing::Test {
protected:
  void TearDown() override { std::filesystem::remove(file_); }

  void write(std::uint32_t format, const std::vector<std::uint16_t>& values) const {
    std::FILE* file = std::fopen(file_.c_str(), "wb");
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_init_io(png, file);
    png_set_IHDR(png, info, 2, 1, 16, static_cast<int>(format), PNG_INTERLACE_NONE,
                 PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
    png_write_info(png, info);
    png_set_swap(png);
    png_write_row(png, reinterpret_cast<png_const_bytep>(values.data()));
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    std::fclose(file);
  }

  std::filesystem::path file_ =
      std::filesystem::temp_directory_path() / ("fulcrum_radiance_" + std::to_string(::getpid()) + ".png");
};

TEST_F(RadianceFile, IsReadAsItsHeaderSays) {
  // The square root of 0.5 / 1.5 and of 0.25 / 1.5: half and a quarter; then nothing at all.
  write(PNG_COLOR_TYPE_RGB_ALPHA, {37837, 26755, 0, 65535, 0, 0, 0, 13107});
  const auto radiance = read_radiance(file_);
  ASSERT_TRUE(radiance) << radiance.error().sentence;
  ASSERT_EQ(radiance->width, 2U);
  ASSERT_EQ(radiance->height, 1U);
  EXPECT_NEAR(radiance->pixels[0].r, 0.5F, 1e-4F);
  EXPECT_NEAR(radiance->pixels[0].g, 0.25F, 1e-4F);
  EXPECT_EQ(radiance->pixels[0].b, 0.0F);
  EXPECT_EQ(radiance->pixels[0].a, 1.0F);
  EXPECT_NEAR(radiance->pixels[1].a, 0.2F, 1e-6F);
}

TEST_F(RadianceFile, OfAnotherKindIsRefused) {
  EXPECT_FALSE(read_radiance(file_));  // none there
  write(PNG_COLOR_TYPE_RGB, {1, 2, 3, 4, 5, 6});
  EXPECT_NE(read_radiance(file_).error().sentence.find("tools/references"), std::string::npos);
  write(PNG_COLOR_TYPE_RGB_ALPHA, {1, 2, 3, 4, 5, 6, 7, 8});
  std::filesystem::resize_file(file_, std::filesystem::file_size(file_) - 20);
  EXPECT_FALSE(read_radiance(file_));
}

}  // namespace
}  // namespace fulcrum::render
