// Choosing the quality from frame times.

#include "engine/render/quality.h"

#include <gtest/gtest.h>

namespace fulcrum::render {
namespace {

// A machine on which a frame costs `cost(quality)`; returns where the choice settles.
template <class Cost>
Quality settled(AutoQuality& choice, Cost cost) {
  for (int i = 0; i < 1000; ++i) choice.add(cost(choice.quality()));
  return choice.quality();
}

double pixels_cost(const Quality& q, double full_s) {
  const double samples = q.samples == 4 ? 1.0 : 0.5;
  return full_s * samples * static_cast<double>(q.resolution_scale * q.resolution_scale);
}

TEST(AutoQuality, AFastMachineKeepsTheBest) {
  AutoQuality choice(1.0 / 30.0);
  EXPECT_EQ(settled(choice, [](const Quality& q) { return pixels_cost(q, 0.002); }), Quality{});
}

TEST(AutoQuality, ASlowMachineEndsWithinItsBudget) {
  AutoQuality choice(1.0 / 30.0);
  const auto cost = [](const Quality& q) { return pixels_cost(q, 0.120); };
  EXPECT_LE(cost(settled(choice, cost)), 1.0 / 30.0);
}

// Two pictures a second are no use to anybody: they are not waited for as long as many pictures take.
TEST(AutoQuality, AVerySlowMachineIsHelpedWithinSeconds) {
  AutoQuality choice(1.0 / 30.0);
  const auto cost = [](const Quality& q) { return pixels_cost(q, 0.5); };
  double waited_s = 0;
  while (choice.quality().resolution_scale > 0.5F && waited_s < 100) {
    const double frame_s = cost(choice.quality());
    waited_s += frame_s;
    choice.add(frame_s);
  }
  EXPECT_LT(waited_s, 8);  // 18 frames at the best level alone would take 9
}

// A step down that helps is not taken back for the sake of three slow frames while something else was busy.
TEST(AutoQuality, AMomentThatIsBusyDoesNotUndoAStepDown) {
  AutoQuality choice(1.0 / 30.0);
  while (choice.quality() == Quality{}) choice.add(0.4);
  const Quality less = choice.quality();
  for (int i = 0; i < 3; ++i) choice.add(0.1);  // not counted
  for (int i = 0; i < 3; ++i) choice.add(0.4);
  for (int i = 0; i < 100; ++i) choice.add(0.1);
  EXPECT_NE(choice.quality(), Quality{});
  EXPECT_LE(choice.quality().resolution_scale, less.resolution_scale);
}

TEST(AutoQuality, AHopelessMachineEndsAtTheLowestAndStays) {
  AutoQuality choice(1.0 / 30.0);
  const auto cost = [](const Quality& q) { return pixels_cost(q, q.shadow_size == 0 ? 10.0 : 15.0); };
  const Quality lowest = settled(choice, cost);
  EXPECT_EQ(lowest.shadow_size, 0);
  EXPECT_FALSE(choice.add(cost(lowest)));
}

TEST(AutoQuality, WhatDoesNotHelpIsTakenBackAndNotTriedAgain) {
  AutoQuality nothing_helps(1.0 / 30.0);
  EXPECT_EQ(settled(nothing_helps, [](const Quality&) { return 1.0; }), Quality{});

  // Vertices take 60 ms whatever the number of pixels: three quarters help, a half does not.
  AutoQuality choice(1.0 / 30.0);
  const auto cost = [](const Quality& q) { return 0.06 + pixels_cost(q, 0.07); };
  const Quality kept = settled(choice, cost);
  EXPECT_EQ(kept.resolution_scale, 0.75F);
  int changes = 0;
  for (int i = 0; i < 1000; ++i) changes += choice.add(cost(choice.quality())) ? 1 : 0;
  EXPECT_EQ(changes, 0);
}

TEST(AutoQuality, DoesNotSwingBetweenTwoLevels) {
  AutoQuality choice(1.0 / 30.0);
  // 4 samples cost three budgets, one sample a tenth of one: going back up would only lead down again.
  const auto cost = [](const Quality& q) { return q.samples == 4 ? 0.1 : 0.003; };
  settled(choice, cost);
  int changes = 0;
  for (int i = 0; i < 1000; ++i) changes += choice.add(cost(choice.quality())) ? 1 : 0;
  EXPECT_EQ(changes, 0);
  EXPECT_EQ(choice.quality().samples, 1);
}

TEST(AutoQuality, IgnoresTheFirstFrames) {
  AutoQuality choice(1.0 / 30.0);
  EXPECT_FALSE(choice.add(3.0));
  EXPECT_FALSE(choice.add(3.0));
  EXPECT_FALSE(choice.add(3.0));
  EXPECT_EQ(settled(choice, [](const Quality&) { return 0.001; }), Quality{});
}

}  // namespace
}  // namespace fulcrum::render
