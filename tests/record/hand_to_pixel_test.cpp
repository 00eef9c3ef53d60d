// Percentiles of stages, against counting; and what a frame may be told that is not so.

#include "engine/record/hand_to_pixel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace fulcrum::record {
namespace {

// The smallest of the times that at least this part of them does not exceed, by trying each. times: ms.
double by_counting(const std::vector<double>& times, double part) {
  double best = 1e9;
  for (const double candidate : times) {
    const auto within = std::ranges::count_if(times, [&](double time) { return time <= candidate; });
    if (static_cast<double>(within) >= part * static_cast<double>(times.size()))
      best = std::min(best, candidate);
  }
  return best;
}

TEST(HandToPixel, NothingIsKnownOfNoFrame) {
  EXPECT_FALSE(HandToPixelMeter().figures());
}

TEST(HandToPixel, StagesAreWhatCountingGives) {
  std::mt19937_64 random(3);
  for (const std::size_t count : {1u, 2u, 7u, 99u, 100u, 101u, 1000u}) {
    HandToPixelMeter meter;
    std::array<std::vector<double>, kStageNames.size()> times;
    for (std::size_t frame = 0; frame < count; ++frame) {
      std::array<std::int64_t, 4> took{};  // ns
      for (std::int64_t& ns : took) ns = static_cast<std::int64_t>(random() % 30'000'000);
      const std::int64_t sampled = 5'000'000'000 + static_cast<std::int64_t>(random() % 1'000'000'000);
      FrameMoments at{sampled, 0, 0, 0, 0};
      at.ticked = at.sampled + took[0];
      at.taken = at.ticked + took[1];
      at.drawn = at.taken + took[2];
      at.shown = at.drawn + took[3];
      meter.add(at);
      for (std::size_t i = 0; i < took.size(); ++i) times[i].push_back(1e-6 * static_cast<double>(took[i]));
      times.back().push_back(1e-6 * static_cast<double>(at.shown - at.sampled));
    }
    const HandToPixel figures = *meter.figures();
    EXPECT_EQ(figures.frames, static_cast<std::int64_t>(count));
    for (std::size_t i = 0; i < times.size(); ++i) {
      const StageFigures& stage = figures.stages[i];
      for (const auto& [got, wanted] : {std::pair(stage.p50_ms, by_counting(times[i], 0.5)),
                                        {stage.p99_ms, by_counting(times[i], 0.99)}}) {
        EXPECT_GE(got, wanted) << count << ' ' << kStageNames[i];
        EXPECT_LT(got, wanted + HandToPixelMeter::kStep) << count << ' ' << kStageNames[i];
      }
      EXPECT_NEAR(stage.max_ms, *std::ranges::max_element(times[i]), 1e-9);
      EXPECT_LE(stage.within.size(), 101u);
      EXPECT_EQ(stage.within.front()[1], 0);
      for (const auto& [ms, part] : stage.within) {
        const auto within =
            std::ranges::count_if(times[i], [most = ms + 1e-9](double time) { return time <= most; });
        EXPECT_DOUBLE_EQ(part * static_cast<double>(count), static_cast<double>(within)) << count;
      }
      EXPECT_EQ(stage.within.back()[1], 1);
    }
  }
}

TEST(HandToPixel, AFrameThatHungIsCountedAndItsTimeIsTold) {
  HandToPixelMeter meter;
  for (int i = 0; i < 99; ++i) meter.add({0, 0, 0, 2'000'000, 2'000'000});
  meter.add({0, 0, 0, 7'000'000'000, 7'000'000'000});
  meter.add({10, 0, -5, -7, -9});  // a clock that went back
  const HandToPixel figures = *meter.figures();
  EXPECT_EQ(figures.of(Stage::draw).max_ms, 7000);
  EXPECT_LE(figures.of(Stage::draw).p99_ms, 2.1);
  EXPECT_EQ(figures.of(Stage::draw).within.back()[0], 7000);
  EXPECT_EQ(figures.of(Stage::show).max_ms, 0);
}

}  // namespace
}  // namespace fulcrum::record
