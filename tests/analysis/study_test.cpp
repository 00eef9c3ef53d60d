#include <gtest/gtest.h>

#include "engine/analysis/stability/report.h"

namespace fulcrum::analysis::stability {
namespace {

StabilityStudy small_study() {
  StabilityStudy study;
  study.devices = {reference_axis(), {"a, b", {.mass = 0.07, .friction = 0.04, .encoder_step = 28e-6}}};
  study.borders = {{"reference", 0, 0, 1000.5, 1000.834, 1000},
                   {"reference", 0, 2, 4900, 4905.3, 0},
                   {"reference", 1, 0, 333, 333.8, 333.3},
                   {"a, b", 0, 0, 990, 10, 10}};
  study.growth = {{0, 1, 2}, {0, 3000}, {-5, 5}};
  study.ticks = {{1e-3, 1000, 1000.834, 1000}};
  study.speeds = {{}, {{0.1, 990}, {1, 100}}};
  study.diolaiti = {{0.1, 1}, {0.1, 1}, {Outcome::trembles}};
  study.energies = {{{900, 0}, {0, 1e-4, -1e-4}}};
  return study;
}

TEST(StabilityReport, CsvHasItsColumns) {
  const std::string text = stability_csv(small_study()).text();
  EXPECT_EQ(text.substr(0, text.find('\n')), "device,delay_ticks,B,K_simulated,K_exact,K_passive");
  EXPECT_NE(text.find("\nreference,0,2,4900,4905.3,0\n"), std::string::npos);
  EXPECT_NE(text.find("\n\"a, b\",0,0,990,10,10\n"), std::string::npos);
}

TEST(StabilityReport, ZWidthIsTheStiffestOfEachKind) {
  const std::vector<ZWidth> widths = z_widths(small_study().borders);
  ASSERT_EQ(widths.size(), 3u);
  EXPECT_EQ(widths[0].simulated.K_simulated, 4900);
  EXPECT_EQ(widths[0].simulated.B, 2);
  EXPECT_EQ(widths[0].passive.K_passive, 1000);
  EXPECT_EQ(widths[0].passive.B, 0);
  EXPECT_EQ(widths[1].delay_ticks, 1);
  EXPECT_EQ(widths[2].device, "a, b");
}

TEST(StabilityReport, PageShowsEveryDevice) {
  const std::string html = stability_page(small_study()).html();
  for (const char* text : {"a, b", "reference", "4900 at B = 2", "Colgate", "Diolaiti", "<svg", "N s/m"})
    EXPECT_NE(html.find(text), std::string::npos) << text;
}

// A device of the kind of content/devices, with all that `fulcrum stability` does.
TEST(StabilityStudy, LinearDevicesDoAsTheoryLong) {
  const NamedAxis model{"model", {.mass = 0.072, .damping = 0.005, .friction = 0.038, .encoder_step = 28e-6}};
  const StabilityStudy study = study_stability({model}, [](std::string_view, double) {});
  ASSERT_EQ(study.devices.size(), 3u);
  std::size_t compared = 0;
  for (const Border& border : study.borders) {
    EXPECT_LE(border.K_passive, border.K_exact * (1 + 1e-9)) << border.device << " " << border.B;
    if (border.device == model.name) continue;
    EXPECT_NEAR(border.K_simulated, border.K_exact, 0.05 * border.K_exact)
        << border.device << " " << border.B;
    ++compared;
  }
  EXPECT_GT(compared, 100u);
  for (std::size_t i = 1; i < study.speeds[2].size(); ++i)
    EXPECT_LT(study.speeds[2][i].K_simulated, study.speeds[2][i - 1].K_simulated) << "faster holds less";
}

}  // namespace
}  // namespace fulcrum::analysis::stability
