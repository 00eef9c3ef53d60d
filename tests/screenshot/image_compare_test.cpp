// The comparer itself, and PNG files there and back.

#include "image_compare.h"

#include <gtest/gtest.h>

namespace fulcrum::test {
namespace {
namespace fs = std::filesystem;

render::Picture grey(std::uint32_t width, std::uint32_t height) {
  render::Picture picture{width, height, std::vector<std::uint8_t>(std::size_t{width} * height * 4, 128)};
  for (std::size_t i = 3; i < picture.rgba.size(); i += 4) picture.rgba[i] = 255;
  return picture;
}

fs::path fresh_folder() {
  const fs::path folder =
      fs::path(testing::TempDir()) /
      (std::string("fulcrum_") + testing::UnitTest::GetInstance()->current_test_info()->name());
  fs::remove_all(folder);
  fs::create_directories(folder);
  return folder;
}

TEST(ImageCompare, TheSamePicturePasses) {
  const Comparison result = compare(grey(8, 4), grey(8, 4), {});
  EXPECT_TRUE(result.passed);
  EXPECT_EQ(result.largest_lsb, 0);
  EXPECT_EQ(result.pixels_by_one, 0U);
  EXPECT_EQ(result.pixels_by_more, 0U);
}

TEST(ImageCompare, CountsPixelsAndTheLargestDifference) {
  render::Picture other = grey(8, 4);
  other.rgba[0] = 129;
  other.rgba[1] = 126;  // the same pixel
  other.rgba[12] = 127;
  other.rgba[21] = 125;
  const CompareOptions just{
      .max_lsb = 3, .max_pixels = 2, .max_share_by_one = 1.0 / 32, .failure_folder = {}};
  const Comparison result = compare(other, grey(8, 4), just);
  EXPECT_TRUE(result.passed);
  EXPECT_EQ(result.largest_lsb, 3);
  EXPECT_EQ(result.pixels_by_one, 1U);
  EXPECT_EQ(result.pixels_by_more, 2U);
  CompareOptions strict = just;
  strict.max_lsb = 2;
  EXPECT_FALSE(compare(other, grey(8, 4), strict).passed);
  strict = just;
  strict.max_pixels = 1;
  EXPECT_FALSE(compare(other, grey(8, 4), strict).passed);
  strict = just;
  strict.max_share_by_one = 0;
  EXPECT_FALSE(compare(other, grey(8, 4), strict).passed);
}

TEST(ImageCompare, AnotherSizeFails) {
  EXPECT_FALSE(compare(grey(8, 4), grey(4, 8), {}).passed);
}

TEST(ImageCompare, AFailureLeavesTwoPictures) {
  const fs::path folder = fresh_folder();
  ASSERT_FALSE(render::write_png(folder / "scene.png", grey(8, 4)));
  render::Picture other = grey(8, 4);
  other.rgba[4] = 138;
  const Comparison result = compare(other, folder / "scene.png",
                                    {.max_lsb = 2, .max_pixels = 50, .failure_folder = folder / "failed"});
  EXPECT_FALSE(result.passed);
  EXPECT_EQ(read_png(folder / "failed/scene.actual.png")->rgba, other.rgba);
  const render::Picture diff = *read_png(folder / "failed/scene.diff.png");
  EXPECT_EQ(diff.rgba[4], 160);  // 10 times 16
  EXPECT_EQ(diff.rgba[0], 0);
}

TEST(ImageCompare, AMissingGoldenFailsAndKeepsThePicture) {
  const fs::path folder = fresh_folder();
  const Comparison result =
      compare(grey(8, 4), folder / "none.png", {.max_lsb = 2, .max_pixels = 50, .failure_folder = folder});
  EXPECT_FALSE(result.passed);
  EXPECT_TRUE(fs::exists(folder / "none.actual.png"));
}

TEST(Png, AFolderThatIsNotThereIsNamed) {
  const auto written = render::write_png("/nonexistent/picture.png", grey(2, 2));
  ASSERT_TRUE(written);
  EXPECT_NE(written->sentence.find("/nonexistent/picture.png"), std::string::npos);
}

TEST(Png, AFullDiskIsNamed) {
  const auto written = render::write_png("/dev/full", grey(64, 64));
  ASSERT_TRUE(written);
  EXPECT_NE(written->sentence.find("disk full"), std::string::npos);
  EXPECT_TRUE(fs::is_character_file("/dev/full")) << "the device was taken for a torn picture";
}

}  // namespace
}  // namespace fulcrum::test
