// Choosing the quality from frame times.

#include "engine/render/quality.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

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

// How long frames have taken until it draws at the best level; costs as they are on that machine.
template <class Cost>
double until_best(AutoQuality& choice, Cost cost) {
  double taken_s = 0;
  while (choice.quality() != kQualityLevels.front() && taken_s < 100) {
    const double frame_s = cost(choice.quality());
    taken_s += frame_s;
    choice.add(frame_s);
  }
  return taken_s;
}

TEST(AutoQuality, BeginsWithTheCheapestWhichHasShadows) {
  EXPECT_EQ(AutoQuality().quality(), kQualityLevels.back());
  for (const Quality& quality : kQualityLevels) EXPECT_GT(quality.shadow_size, 0);
}

TEST(AutoQuality, EachLevelAsksForNoMoreThanTheOneAbove) {
  for (std::size_t i = 1; i < kQualityLevels.size(); ++i) {
    const Quality &better = kQualityLevels[i - 1], &cheaper = kQualityLevels[i];
    EXPECT_LE(cheaper.samples, better.samples);
    EXPECT_LE(cheaper.shadow_size, better.shadow_size);
    EXPECT_LE(cheaper.resolution_scale, better.resolution_scale);
    EXPECT_GE(cheaper.coarseness, better.coarseness);
    EXPECT_LE(cheaper.soft_shadows, better.soft_shadows);
    EXPECT_LE(cheaper.scattering, better.scattering);
    EXPECT_LE(cheaper.reflections, better.reflections);
  }
}

TEST(AutoQuality, AFastMachineHasTheBestWithinASecond) {
  AutoQuality choice(1.0 / 30.0);
  const auto at_sixty = [](const Quality&) { return 1.0 / 60.0; };
  EXPECT_LT(until_best(choice, at_sixty), 1.0);
  EXPECT_EQ(settled(choice, at_sixty), kQualityLevels.front());
}

TEST(AutoQuality, ASlowMachineEndsWithinItsBudget) {
  AutoQuality choice(1.0 / 30.0);
  const auto cost = [](const Quality& q) { return pixels_cost(q, 0.120); };
  const Quality chosen = settled(choice, cost);
  EXPECT_LE(cost(chosen), 1.0 / 30.0);
  EXPECT_NE(chosen, kQualityLevels.back());  // a better one does, too
}

// What is too slow is left again after a few frames.
TEST(AutoQuality, ATooSlowLevelIsLeftWithinSeconds) {
  AutoQuality choice(1.0 / 30.0);
  const auto cost = [](const Quality& q) { return q == kQualityLevels.back() ? 0.02 : 0.5; };
  while (choice.quality() == kQualityLevels.back()) choice.add(cost(choice.quality()));
  double waited_s = 0;
  while (choice.quality() != kQualityLevels.back() && waited_s < 100) {
    const double frame_s = cost(choice.quality());
    waited_s += frame_s;
    choice.add(frame_s);
  }
  EXPECT_LT(waited_s, 4);
}

// In a scene that becomes dear, as where somebody goes close to it.
TEST(AutoQuality, WhatBecomesTooSlowIsLeft) {
  AutoQuality choice(1.0 / 30.0);
  settled(choice, [](const Quality&) { return 0.01; });
  ASSERT_EQ(choice.quality(), kQualityLevels.front());
  const auto cost = [](const Quality& q) { return pixels_cost(q, 0.2); };
  double waited_s = 0;
  while (cost(choice.quality()) > 1.0 / 30.0 && waited_s < 100) {
    const double frame_s = cost(choice.quality());
    waited_s += frame_s;
    choice.add(frame_s);
  }
  EXPECT_LT(waited_s, 8);
}

// A level that was hardly over its budget was kept, since the one below gained little; in another view it
// takes ten times as long, and is left at once and not after the pause.
TEST(AutoQuality, WhatWasLearntOfOneViewIsForgottenInAnother) {
  AutoQuality choice(1.0 / 30.0);
  const auto hardly = [](const Quality& q) { return q == kQualityLevels.back() ? 0.030 : 0.036; };
  for (int i = 0; i < 100; ++i) choice.add(hardly(choice.quality()));
  ASSERT_NE(choice.quality(), kQualityLevels.back());
  const auto cost = [](const Quality& q) { return pixels_cost(q, 0.5); };
  double waited_s = 0;
  while (cost(choice.quality()) > 1.0 / 30.0 && waited_s < 100) {
    const double frame_s = cost(choice.quality());
    waited_s += frame_s;
    choice.add(frame_s);
  }
  EXPECT_LT(waited_s, 8);
}

// A quarter more for each of four steps would be 2.4 times as much. The lowest level holds the budget, or
// not.
TEST(AutoQuality, AClimbBeyondTheBudgetCostsAQuarterInAll) {
  constexpr std::array<std::array<double, 5>, 2> kTimes = {
      {{0.070, 0.057, 0.047, 0.039, 0.032}, {0.095, 0.077, 0.063, 0.051, 0.042}}};
  for (const std::array<double, 5>& times : kTimes) {
    AutoQuality choice(1.0 / 30.0);
    const auto cost = [&](const Quality& q) {
      return times[static_cast<std::size_t>(std::ranges::find(kQualityLevels, q) - kQualityLevels.begin())];
    };
    for (int i = 0; i < 20; ++i)
      EXPECT_LE(cost(settled(choice, cost)), 1.25 * std::max(times.back(), 1.0 / 30.0));
  }
}

// A level that is twice as dear, and beyond the budget, is not kept for being nearly within it: a headset
// would drop pictures.
TEST(AutoQuality, WhatIsMuchDearerAndBeyondTheBudgetIsLeft) {
  AutoQuality choice(0.8);
  const auto cost = [](const Quality& q) {
    return q == kQualityLevels[0] ? 1.26 : q == kQualityLevels[1] ? 0.98 : 0.49;
  };
  double beyond_s = 0, all_s = 0;
  while (all_s < 5000) {
    const double now = cost(choice.quality());
    all_s += now;
    if (now > 0.8) beyond_s += now;
    choice.add(now);
  }
  EXPECT_LT(beyond_s, 0.15 * all_s);
}

// Whatever time passes, and however fast the machine is.
TEST(AutoQuality, WhatIsRefusedIsChosenNoMore) {
  AutoQuality choice(1.0 / 30.0);
  const auto fast = [](const Quality&) { return 0.01; };
  settled(choice, fast);
  ASSERT_TRUE(choice.refuse());
  EXPECT_EQ(choice.quality(), kQualityLevels[1]);
  for (int i = 0; i < 60; ++i) EXPECT_EQ(settled(choice, fast), kQualityLevels[1]);
  const auto slow = [](const Quality& q) { return pixels_cost(q, 0.120); };
  EXPECT_LE(slow(settled(choice, slow)), 1.0 / 30.0);
  while (choice.quality() != kQualityLevels.back()) ASSERT_TRUE(choice.refuse());
  EXPECT_FALSE(choice.refuse());
  EXPECT_EQ(settled(choice, fast), kQualityLevels.back());
}

TEST(AutoQuality, AHopelessMachineStaysAtTheLowest) {
  AutoQuality choice(1.0 / 30.0);
  int changes = 0;
  for (int i = 0; i < 1000; ++i) changes += choice.add(pixels_cost(choice.quality(), 60.0)) ? 1 : 0;
  EXPECT_EQ(changes, 0);
  EXPECT_EQ(choice.quality(), kQualityLevels.back());
}

// Vertices take 60 ms whatever the number of pixels, the processor is the limit, or some such.
TEST(AutoQuality, WhereLessDoesNotHelpThePictureIsGood) {
  AutoQuality choice(1.0 / 30.0);
  const auto cost = [](const Quality& q) { return 0.06 + pixels_cost(q, 0.01); };
  EXPECT_EQ(settled(choice, cost), kQualityLevels.front());

  AutoQuality half(1.0 / 30.0);
  const auto samples_cost = [](const Quality& q) { return q.samples == 4 ? 0.2 : 0.06; };
  EXPECT_EQ(settled(half, samples_cost), kQualityLevels[1]);
}

TEST(AutoQuality, AStepDownThatDoesNotHelpIsTakenBack) {
  AutoQuality choice(1.0 / 30.0);
  settled(
      choice, [](const Quality&) { return 0.01; });
  const auto all_alike = [](const Quality&) { return 0.08; };
  EXPECT_EQ(settled(choice, all_alike), kQualityLevels.front());
}

// A step down that helps is not taken back for the sake of three slow frames while something else was busy.
TEST(AutoQuality, AMomentThatIsBusyDoesNotUndoAStepDown) {
  AutoQuality choice(1.0 / 30.0);
  settled(choice, [](const Quality&) { return 0.01; });
  while (choice.quality() == kQualityLevels.front()) choice.add(0.4);
  for (int i = 0; i < 3; ++i) choice.add(0.1);  // not counted
  for (int i = 0; i < 3; ++i) choice.add(0.4);
  for (int i = 0; i < 100; ++i) choice.add(0.1);
  EXPECT_NE(choice.quality(), kQualityLevels.front());
}

// It goes up, back down, and up again after 20, 40, 80 .. s.
TEST(AutoQuality, DoesNotSwingBetweenTwoLevels) {
  AutoQuality choice(1.0 / 30.0);
  const auto cost = [](const Quality& q) { return q.samples == 4 ? 0.1 : 0.02; };
  int changes = 0;
  double best_s = 0, all_s = 0;
  while (all_s < 600) {
    const double frame_s = cost(choice.quality());
    all_s += frame_s;
    best_s += choice.quality().samples == 4 ? frame_s : 0.0;
    changes += choice.add(frame_s) ? 1 : 0;
  }
  EXPECT_LE(changes, 3 + 2 * 6);
  EXPECT_LT(best_s, 0.02 * all_s);
}

// A machine that was busy while the scene began is not held at a poor picture for that.
TEST(AutoQuality, WhatWasTooSlowOnceIsTriedAgain) {
  AutoQuality choice(1.0 / 30.0);
  const auto busy = [](const Quality& q) { return q == kQualityLevels.back() ? 0.02 : 0.09; };
  for (int i = 0; i < 100; ++i) choice.add(busy(choice.quality()));
  ASSERT_EQ(choice.quality(), kQualityLevels.back());
  EXPECT_LT(until_best(choice, [](const Quality&) { return 0.02; }), 25.0);
}

TEST(AutoQuality, IgnoresTheFirstFrames) {
  AutoQuality choice(1.0 / 30.0);
  for (int i = 0; i < 3; ++i) EXPECT_FALSE(choice.add(3.0));
  EXPECT_EQ(settled(choice, [](const Quality&) { return 0.001; }), kQualityLevels.front());
}

}  // namespace
}  // namespace fulcrum::render
