#include "engine/session/score.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace fulcrum::session {
namespace {

TrialMetrics expert() {
  TrialMetrics metrics;
  metrics.time = 20;
  metrics.completed = true;
  metrics.checkpoints = metrics.checkpoints_reached = 4;
  metrics.path = 0.5;
  metrics.smoothness = -5;
  metrics.force_95 = 1;
  metrics.touches_on_the_way = 1;
  return metrics;
}

std::string reason(const Score& score, const std::string& name) {
  const auto found = std::ranges::find(score.criteria, name, &Criterion::name);
  EXPECT_NE(found, score.criteria.end()) << name;
  return found == score.criteria.end() ? "" : found->reason;
}

double points(const Score& score, const std::string& name) {
  const auto found = std::ranges::find(score.criteria, name, &Criterion::name);
  EXPECT_NE(found, score.criteria.end()) << name;
  return found == score.criteria.end() ? -1 : found->points.value_or(-1);
}

TEST(Score, IsFullForTheExpert) {
  const TrialMetrics best = expert();
  const Score all = score(best, &best);
  ASSERT_TRUE(all.total);
  EXPECT_DOUBLE_EQ(*all.total, 100);
}

TEST(Score, FallsEvenlyBetweenOneAndAHalfAndFourTimesTheExperts) {
  const TrialMetrics best = expert();
  TrialMetrics trial = best;
  for (const auto& [ratio, expected] : {std::pair(1.5, 15.0), {2.75, 7.5}, {4.0, 0.0}, {9.0, 0.0}}) {
    trial.time = ratio * best.time;
    EXPECT_NEAR(points(score(trial, &best), "Time"), expected, 1e-9);
    EXPECT_NEAR(*score(trial, &best).total, 100 * (100 + expected) / 115.0, 1e-9);
  }
}

TEST(Score, OfWhatWasNotCompletedIsItsCheckpointsAlone) {
  const TrialMetrics best = expert();
  TrialMetrics trial = best;
  trial.completed = false;
  trial.checkpoints_reached = 1;
  trial.time = 1;
  const Score all = score(trial, &best);
  EXPECT_EQ(points(all, "Checkpoints"), 10);
  EXPECT_EQ(points(all, "Time"), 0);
  EXPECT_NEAR(*all.total, 100 * 10 / 115.0, 1e-9);
}

TEST(Score, CostsThreePointsAHardTouch) {
  const TrialMetrics best = expert();
  TrialMetrics trial = best;
  trial.hard_touches = 2;
  EXPECT_EQ(points(score(trial, &best), "Hard touches"), 9);
  trial.hard_touches = 50;
  EXPECT_EQ(points(score(trial, &best), "Hard touches"), 0);
  trial.hard_touches = 0;
  trial.completed = false;
  trial.checkpoints_reached = 0;
  EXPECT_EQ(points(score(trial, &best), "Hard touches"), 0) << "who has done nothing has not done it gently";
}

TEST(Score, HasNoTotalWithoutAnExpertWhoCompletes) {
  const TrialMetrics trial = expert();
  EXPECT_FALSE(score(trial, nullptr).total);
  TrialMetrics failed = expert();
  failed.completed = false;
  EXPECT_FALSE(score(trial, &failed).total);
  EXPECT_EQ(points(score(trial, nullptr), "Checkpoints"), 40);
  EXPECT_EQ(reason(score(trial, nullptr), "Time"), "There is no expert to compare with.");
  EXPECT_NE(reason(score(trial, &failed), "Time").find("did not complete"), std::string::npos);
}

TEST(Score, SaysWhichFigureTheExpertLacks) {
  TrialMetrics still = expert();
  still.path = 0;
  EXPECT_NE(reason(score(expert(), &still), "Path").find("no such figure"), std::string::npos);
  EXPECT_EQ(points(score(expert(), &still), "Time"), 15);
}

TEST(Score, DoesNotDivideByAnExpertWhoTouchesNothing) {
  TrialMetrics best = expert(), trial = expert();
  best.force_95 = 0;
  best.touches_on_the_way = 0;
  trial.force_95 = 0.05;
  trial.touches_on_the_way = 0;
  EXPECT_DOUBLE_EQ(*score(trial, &best).total, 100);
  best.time = 0;
  EXPECT_TRUE(score(trial, &best).total);
}

TEST(Score, OfAGuidedTrialIsNone) {
  const TrialMetrics best = expert();
  TrialMetrics trial = best;
  trial.hard_touches = 0;
  trial.guided = true;
  const Score all = score(trial, &best);
  EXPECT_FALSE(all.total);
  ASSERT_FALSE(all.criteria.empty());
  EXPECT_EQ(all.criteria.front().name, "Guided");
  for (const Criterion& criterion : all.criteria) EXPECT_FALSE(criterion.points) << criterion.name;
  EXPECT_EQ(all.criteria.size(), score(best, &best).criteria.size() + 2) << "its figures are told";
}

TEST(Score, GoesByTheTasksWeights) {
  const TrialMetrics best = expert();
  TrialMetrics trial = best;
  trial.checkpoints_reached = 2;
  trial.optional_checkpoints = 4;
  trial.optional_reached = 1;
  trial.slips = 1;
  trial.trespasses = 2;
  trial.time = 2.75 * best.time;
  const Score all =
      score(trial, &best, {.checkpoints = 60, .optional = 8, .time = 30, .path = 0, .slips = 10});
  EXPECT_EQ(points(all, "Checkpoints"), 30);
  EXPECT_EQ(points(all, "Optional checkpoints"), 2);
  EXPECT_NEAR(points(all, "Time"), 15, 1e-9);
  EXPECT_EQ(points(all, "Path"), -1) << "told, and not judged";
  EXPECT_NEAR(points(all, "Slips"), 8, 1e-9);
  EXPECT_NEAR(points(all, "Trespasses"), 9, 1e-9);
  EXPECT_NEAR(*all.total, 100 * (30 + 2 + 15 + 8 + 9 + 45) / (60 + 8 + 30 + 10 + 15 + 45.0), 1e-9);
}

TEST(Score, WithoutPointsForComparisonsNeedsNoExpert) {
  TrialMetrics trial = expert();
  trial.hard_touches = 1;
  const scenario::ScoreWeights weights{
      .time = 0, .path = 0, .force = 0, .smoothness = 0, .touches = 0, .hard_touches = 60};
  ASSERT_TRUE(score(trial, nullptr, weights).total);
  EXPECT_NEAR(*score(trial, nullptr, weights).total, 88, 1e-9);
  EXPECT_FALSE(score(trial, nullptr,
                     {.checkpoints = 0,
                      .time = 0,
                      .path = 0,
                      .force = 0,
                      .smoothness = 0,
                      .touches = 0,
                      .hard_touches = 0})
                   .total)
      << "there are no points at all";
}

TEST(TrialMetrics, KeepTheirValuesUnderTheirNames) {
  TrialMetrics metrics = expert();
  metrics.hard_touches = 3;
  metrics.hard_touch_time = 0.25;
  metrics.depth_peak = 1.0 / 3;
  metrics.optional_checkpoints = 2;
  metrics.optional_reached = 1;
  metrics.slips = 4;
  metrics.trespasses = 5;
  metrics.trespass_time = 0.5;
  const TrialMetrics again = from_named_values(named_values(metrics));
  EXPECT_EQ(named_values(again), named_values(metrics));
  EXPECT_EQ(named_values(metrics).size(), metric_names().size());
  EXPECT_EQ(named_values(TrialMetrics()).size() + 4, metric_names().size())
      << "no smoothness, no hard touches, no slips, no trespasses";
  EXPECT_EQ(from_named_values({{"checkpoints", 1e300}, {"nonsense", 1}}).checkpoints, 0);
}

}  // namespace
}  // namespace fulcrum::session
