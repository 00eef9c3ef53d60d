// Light that spreads below a surface does so as Burley's profile says.
//
// A floor seen from above, of which one half is lit: each point of the edge's neighbourhood receives from the
// circle of radius r around it the part of that circle that lies in the lit half. The profile's own share of
// r is integrated over all r here, in double precision, and nothing of the renderer's is used for it.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/render/frame_data.h"
#include "engine/render/tone.h"
#include "half_lit_floor.h"

namespace fulcrum::render {
namespace {

using test::HalfLitFloor;

class ScatteringTest : public HalfLitFloor {};

// x: away from the edge into the dark (m); d: scatter distance (m).
double spread_from_half(double x, double d) {
  if (x < 0.0) return 1.0 - spread_from_half(-x, d);
  constexpr int kSteps = 4000;
  const double far = x + 40.0 * d;
  double sum = 0.0;
  for (int i = 0; i < kSteps; ++i) {
    const double r = x + (far - x) * (i + 0.5) / kSteps;
    const double share = (std::exp(-r / d) + std::exp(-r / (3.0 * d))) / (4.0 * d);
    sum += share * std::acos(x / r) / std::numbers::pi;
  }
  return sum * (far - x) / kSteps;
}

struct Off {
  double mean = 0.0;   // root mean square, of white
  double worst = 0.0;  // of one pixel
};

// Of the middle rows and columns: beyond, the picture's edge is nearer than light spreads.
Off off_truth(const Picture& picture, const glm::vec3& d, float across) {
  Off off;
  int count = 0;
  for (std::uint32_t x = HalfLitFloor::kSize.width / 4; x < HalfLitFloor::kSize.width * 3 / 4; ++x) {
    const double from_edge = ((x + 0.5) / HalfLitFloor::kSize.width - 0.5) * across;
    glm::vec3 light;
    for (int i = 0; i < 3; ++i) light[i] = static_cast<float>(spread_from_half(from_edge, d[i]));
    const glm::vec3 wanted = tone_mapped(HalfLitFloor::kReflected * light);
    for (std::uint32_t y = HalfLitFloor::kSize.height / 2 - 16; y < HalfLitFloor::kSize.height / 2 + 16; ++y)
      for (int i = 0; i < 3; ++i) {
        const double by =
            std::abs(HalfLitFloor::at(picture, x, y, static_cast<std::size_t>(i)) / 255.0 - wanted[i]);
        off.mean += by * by;
        off.worst = std::max(off.worst, by);
        ++count;
      }
  }
  off.mean = std::sqrt(off.mean / count);
  return off;
}

TEST_F(ScatteringTest, AHalfLitFloorIsAsTheProfileSaysFromAnyDistance) {
  for (const float pixels : {1.0F, 2.0F, 4.0F, 6.0F})
    for (const float away : {0.1F, 0.4F, 1.6F}) {
      const float across = 0.2F * away;
      const glm::vec3 d(pixels * across / kSize.width);
      const Off off = off_truth(drawn(half_lit(d, across, away), quality(16)), d, across);
      EXPECT_LT(off.mean, 0.01) << pixels << " px, from " << away;
      EXPECT_LT(off.worst, 0.06) << pixels << " px, from " << away;
    }
}

TEST_F(ScatteringTest, EachColourSpreadsByItsOwnDistance) {
  constexpr float across = 0.1F;
  const glm::vec3 d = glm::vec3(6.0F, 2.5F, 1.5F) * (across / kSize.width);
  const Off off = off_truth(drawn(half_lit(d, across), quality(16)), d, across);
  EXPECT_LT(off.mean, 0.01);
  EXPECT_LT(off.worst, 0.06);
}

// The curve of docs/looks.md. From 32 on what is left is the width of the four pixels that are put together.
TEST_F(ScatteringTest, MoreSamplesLessError) {
  constexpr float across = 0.1F;
  const glm::vec3 d = glm::vec3(6.0F, 2.5F, 1.5F) * (across / kSize.width);
  double before = 1.0;
  for (const int taps : {2, 4, 8, 16, 32, 64}) {
    const Off off = off_truth(drawn(half_lit(d, across), quality(taps)), d, across);
    EXPECT_LT(off.mean, taps < 64 ? before : 0.005) << taps;
    before = off.mean;
    RecordProperty("samples_" + std::to_string(taps) + "_mean", std::to_string(off.mean));
    RecordProperty("samples_" + std::to_string(taps) + "_worst", std::to_string(off.worst));
  }
}

// The half lit floor, seen so obliquely that it recedes across the edge by twice what it is wide.
TEST_F(ScatteringTest, ATiltedFloorIsLitAsALevelOne) {
  const glm::vec3 d(0.004F);
  VisualDesc desc = half_lit(d, 0.1F);
  desc.camera = {{0.45F, 0.225F, 0.0F}, glm::vec3(0.0F), 0.2F};
  const Picture picture = drawn(desc, quality(16));
  for (int i = -8; i <= 8; ++i) {
    const float x = 0.002F * static_cast<float>(i);
    const glm::vec4 clip = clip_from_world(desc.camera, kSize) * glm::vec4(x, 0, 0, 1);
    const float y = 0.5F - 0.5F * clip.y / clip.w, half = 0.5F / static_cast<float>(kSize.height);
    const float seen = test::mean(picture, 0.4F, y - half, 0.6F, y + half).g / 255.0F;
    const auto light = static_cast<float>(spread_from_half(x, d.g));
    if (i != 0) EXPECT_NEAR(seen, tone_mapped(glm::vec3(kReflected * light)).g, 0.04F) << x;
  }
}

}  // namespace
}  // namespace fulcrum::render
