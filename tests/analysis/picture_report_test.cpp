#include "engine/analysis/picture/report.h"

#include <gtest/gtest.h>

#include <regex>
#include <set>
#include <string>

namespace fulcrum::analysis::picture {
namespace {

Image grey(float value) {
  return {10, 10, std::vector<std::array<float, 3>>(100, {value, value, value})};
}

TEST(PictureFigures, AreThoseOfThePixels) {
  std::vector<double> map;
  const LevelFigures same = compared(grey(0.5F), grey(0.5F), map);
  EXPECT_EQ(same.flip_mean, 0);
  EXPECT_EQ(same.luminance_error, 0);
  ASSERT_EQ(map.size(), 100U);
  // 0.5 on a screen is 0.2140 of its light, 0.7 is 0.4479.
  const LevelFigures brighter = compared(grey(0.5F), grey(0.7F), map);
  EXPECT_NEAR(brighter.luminance_error, 0.4479 / 0.2140 - 1, 1e-3);
  EXPECT_NEAR(brighter.flip_mean, brighter.flip_p99, 1e-9);
  EXPECT_LT(compared(grey(0.7F), grey(0.5F), map).luminance_error, 0);
  EXPECT_EQ(compared(grey(0), grey(0.5F), map).luminance_error, 0) << "of no light nothing can be said";
}

// One pixel of a hundred is the last one percent.
TEST(PictureFigures, LeaveTheLastPercentOut) {
  Image one = grey(0.5F);
  one.pixels[55] = {1, 1, 1};
  std::vector<double> map;
  const LevelFigures figures = compared(grey(0.5F), one, map);
  EXPECT_LT(figures.flip_p99, map[55]);
  EXPECT_GT(figures.flip_p99, 0);
}

TEST(PictureFigures, HaveMapsThatGetLighter) {
  std::vector<double> rising;
  for (int i = 0; i <= 20; ++i) rising.push_back(i / 20.0);
  const Image map = coloured(rising, 21);
  ASSERT_EQ(map.height, 1U);
  const auto lightness = [&](std::size_t i) {
    return 0.2126F * map.pixels[i][0] + 0.7152F * map.pixels[i][1] + 0.0722F * map.pixels[i][2];
  };
  EXPECT_EQ(lightness(0), 0);
  for (std::size_t i = 1; i < rising.size(); ++i) EXPECT_GT(lightness(i), lightness(i - 1));
}

std::vector<ViewFigures> two_views() {
  const std::vector<LevelFigures> levels = {{"whole", 0.1, 0.3, 0.02, 40}, {"half", 0.2, 0.5, -0.04, 10}};
  std::vector<LevelFigures> others = levels;
  others[0].flip_mean = 0.2;
  return {{"ear", "front", 0, levels, {{"Reference", "png"}}, false},
          {"nut", "above", 2.5, others, {}, true}};
}

TEST(PictureReport, HasALineForEachLevel) {
  const std::string csv = picture_csv(two_views()).text();
  EXPECT_EQ(csv.substr(0, csv.find('\n')), "scene,view,level,flip_mean,flip_p99,luminance_error,frame_ms");
  EXPECT_NE(csv.find("ear,front,1,0.2,0.5,-0.04,10\n"), csv.npos);
  const report::Table table = level_table(two_views());
  ASSERT_EQ(table.rows.size(), 2U);
  EXPECT_EQ(table.rows[0][2], "0.15");
  EXPECT_EQ(table.rows[1][6], "0.25");
}

TEST(PictureReport, SaysWhichReferenceIsOld) {
  const std::string html = picture_page(two_views(), "fulcrum workprecision picture --scene ear").html();
  EXPECT_NE(html.find("The reference of nut, above, 2.5 s was drawn of another state"), html.npos);
  EXPECT_EQ(html.find("The reference of ear"), html.npos);
  EXPECT_NE(html.find("data:image/png;base64,cG5n"), html.npos);
}

TEST(PictureReport, SaysWhatMakesItAgain) {
  const std::string command = "fulcrum workprecision picture --scene ear --gpu 1";
  EXPECT_NE(picture_page(two_views(), command).html().find(command + "<"), std::string::npos);
}

// The legend shows a line for each scene; no two of them look the same, though there are more than hues.
TEST(PictureReport, TellsEveryShippedSceneFromTheOthersInItsPlot) {
  std::vector<ViewFigures> views;
  for (const char* scene : {"ear", "knock", "nut", "piping", "plate", "stick", "sweep", "teeth", "tutorial"})
    views.push_back({scene, "overview", 0, two_views().front().levels, {}, false});
  const std::string html = picture_page(views, "").html();
  const std::regex line("<path class=\"(line h[^\"]*)\" d=\"M[0-9.]+ [0-9.]+h30\"/>");
  std::set<std::string> looks;
  for (std::sregex_iterator each(html.begin(), html.end(), line); each != std::sregex_iterator(); ++each)
    EXPECT_TRUE(looks.insert((*each)[1]).second) << (*each)[1] << " stands for two scenes";
  EXPECT_EQ(looks.size(), views.size());
}

}  // namespace
}  // namespace fulcrum::analysis::picture
