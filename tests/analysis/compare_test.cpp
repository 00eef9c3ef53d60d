// Truths: tables of Student's t; a mean and its interval worked out by hand.

#include "engine/analysis/compare/compare.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/analysis/compare/figures.h"
#include "engine/analysis/compare/report.h"
#include "engine/analysis/compare/student_t.h"
#include "engine/analysis/compare/tables.h"

namespace fulcrum::analysis::compare {
namespace {

TEST(Student, QuantilesAreThoseOfTheTables) {
  EXPECT_NEAR(t_quantile(0.975, 1), 12.7062, 5e-5);
  EXPECT_NEAR(t_quantile(0.975, 2), 4.30265, 5e-6);
  EXPECT_NEAR(t_quantile(0.975, 4), 2.77645, 5e-6);
  EXPECT_NEAR(t_quantile(0.975, 19), 2.09302, 5e-6);
  EXPECT_NEAR(t_quantile(0.95, 10), 1.81246, 5e-6);
  EXPECT_NEAR(t_quantile(0.995, 3), 5.84091, 5e-6);
  EXPECT_NEAR(t_quantile(0.975, 10000), 1.96020, 5e-6);
  EXPECT_NEAR(t_quantile(0.025, 19), -2.09302, 5e-6);
  EXPECT_NEAR(t_quantile(0.5, 7), 0, 1e-12);
  // In closed form for 1 and 2 degrees of freedom.
  EXPECT_NEAR(t_quantile(0.9, 1), std::tan(0.4 * 3.14159265358979), 1e-9);
  EXPECT_NEAR(t_quantile(0.9, 2), 0.8 / std::sqrt(2 * 0.9 * 0.1), 1e-9);
}

TEST(Estimate, IsMeanAndInterval) {
  const double values[] = {4, 6, 5, 7, 8};  // mean 6, variance 10/4, t = 2.77645
  const Estimate found = estimate(values);
  EXPECT_EQ(found.n, 5u);
  EXPECT_DOUBLE_EQ(found.mean, 6);
  ASSERT_TRUE(found.interval);
  EXPECT_NEAR(found.interval->low, 6 - 1.963243, 1e-5);
  EXPECT_NEAR(found.interval->high, 6 + 1.963243, 1e-5);
}

TEST(Estimate, OfOneValueHasNoIntervalAndOfNoneNoMean) {
  const double one[] = {3};
  EXPECT_EQ(estimate(one).mean, 3);
  EXPECT_FALSE(estimate(one).interval);
  EXPECT_EQ(estimate({}).n, 0u);
}

Trial trial(double torque, std::optional<double> time) {
  return {.seed = 1,
          .torque_error_Nms = torque,
          .force_error_Ns = 10 + torque,
          .completion_time_s = time,
          .fault = {}};
}

Comparison example() {
  Comparison comparison;
  comparison.scenario = "slot";
  comparison.title = "A <slot>";
  comparison.command = "fulcrum compare slot";
  comparison.device = "arm";
  comparison.hand = "yielding";
  comparison.yields = YieldingDesc{.reaction = 0.31, .gain = 1.7};
  comparison.bad_above_Nm = 0.03;
  comparison.variants = {{"A", {trial(5, 40.), trial(6, 41.), trial(7, std::nullopt)}, {}},
                         {"B", {trial(2, 40.), trial(3.5, std::nullopt), trial(4, 40.)}, {}}};
  for (VariantRuns& runs : comparison.variants)
    runs.course = {{0, 0.01, false, 0, 0}, {0.02, 0.2, true, 0.3, 1}, {0.04, 0.02, false, 0, 0.4}};
  return comparison;
}

TEST(Comparison, TrialsWithoutAValueAreNotCounted) {
  const Comparison comparison = example();
  EXPECT_EQ(estimate_of(comparison.variants[0], Metric::completion_time).n, 2u);
  EXPECT_DOUBLE_EQ(estimate_of(comparison.variants[0], Metric::completion_time).mean, 40.5);
  EXPECT_EQ(difference_of(comparison.variants[1], comparison.variants[0], Metric::completion_time).n, 1u)
      << "in one trial alone both completed";
  EXPECT_EQ(estimate_of(comparison.variants[0], Metric::torque_error).n, 3u);
  Trial stopped = trial(1, std::nullopt);
  stopped.fault = "watchdog";
  EXPECT_FALSE(stopped.value(Metric::torque_error)) << "over a part of the run";
}

// Trials that differ far more from each other than the variants do: only in pairs is there a difference.
TEST(Comparison, PairsShowWhatMeansHide) {
  VariantRuns a{"A", {trial(1, {}), trial(5, {}), trial(9, {}), trial(14, {})}, {}};
  VariantRuns b{"B", {trial(0.5, {}), trial(4.6, {}), trial(8.4, {}), trial(13.5, {})}, {}};
  EXPECT_FALSE(apart(estimate_of(a, Metric::torque_error), estimate_of(b, Metric::torque_error)));
  const Estimate difference = difference_of(b, a, Metric::torque_error);
  EXPECT_NEAR(difference.mean, -0.5, 1e-12);
  ASSERT_TRUE(difference.interval);
  EXPECT_LT(difference.interval->high, 0);
}

TEST(Comparison, ApartMeansNoValueInBoth) {
  const Estimate low{3, 1, Interval{0.5, 1.5}}, high{3, 3, Interval{1.6, 4}}, wide{3, 2, Interval{1.4, 3}};
  EXPECT_TRUE(apart(low, high));
  EXPECT_TRUE(apart(high, low));
  EXPECT_FALSE(apart(low, wide));
  EXPECT_FALSE(apart(low, Estimate{1, 9, std::nullopt}));
}

TEST(CompareReport, CsvHasItsColumnsAndLeavesEmptyWhatIsNotKnown) {
  Comparison comparison = example();
  const std::string text = compare_csv(comparison).text();
  EXPECT_TRUE(text.starts_with("metric,variant,n,mean,low,high\nE_tau,A,3,6,")) << text;
  EXPECT_NE(text.find("\nt_c,B,2,40,40,40\n"), std::string::npos) << text;
  for (VariantRuns& runs : comparison.variants) runs.trials.resize(1);
  comparison.variants[1].trials[0].completion_time_s.reset();
  const std::string one = compare_csv(comparison).text();
  EXPECT_NE(one.find("\nE_tau,A,1,5,,\n"), std::string::npos) << one;
  EXPECT_NE(one.find("\nt_c,B,0,,,\n"), std::string::npos) << one;
}

TEST(CompareReport, PageSaysWhatIsSimulated) {
  const std::string html = compare_page(example()).html();
  for (const char* text : {"Nothing here is a finding about people", "0.31", "1.7", "A &lt;slot&gt;", "<svg",
                           "B − A", "did not complete, and have no t_c: 2."})
    EXPECT_NE(html.find(text), std::string::npos) << text;
  Comparison recorded = example();
  recorded.hand.clear();
  recorded.yields.reset();
  recorded.tape = "A/tape";
  const std::string page = compare_page(recorded).html();
  EXPECT_NE(page.find("cannot yield to a cue"), std::string::npos);
  EXPECT_EQ(page.find("reaction time"), std::string::npos) << "a recording has none";
}

TEST(CompareFigures, EachTrialIsALineOverTheVariants) {
  const report::Plot plot = metric_plot(example(), Metric::completion_time);
  ASSERT_EQ(plot.x.names, (std::vector<std::string>{"A", "B"}));
  const std::vector<report::Point>& points = plot.series.front().points;
  ASSERT_EQ(points.size(), 9u);
  EXPECT_EQ(points[0].y, 40);
  EXPECT_EQ(points[1].x, 1);
  EXPECT_TRUE(std::isnan(points[2].y)) << "the line ends with its trial";
  EXPECT_TRUE(std::isnan(points[4].y)) << "B's second did not complete";
}

TEST(CompareFigures, CourseShadesBadTicksAndCues) {
  const report::Plot plot = course_plot(example(), 1);
  ASSERT_EQ(plot.cells.x_edges.size(), 4u);
  ASSERT_EQ(plot.cells.y_edges.size(), 6u);
  const std::vector<int> bad(plot.cells.band.begin(), plot.cells.band.begin() + 3);
  EXPECT_EQ(bad, (std::vector<int>{-1, 0, -1}));
  const std::vector<int> vibration(plot.cells.band.begin() + 6, plot.cells.band.begin() + 9);
  EXPECT_EQ(vibration, (std::vector<int>{-1, 4, -1}));
  const std::vector<int> ghost(plot.cells.band.begin() + 12, plot.cells.band.end());
  EXPECT_EQ(ghost, (std::vector<int>{-1, 4, 2}));
}

}  // namespace
}  // namespace fulcrum::analysis::compare
