// Pairs of features between parts that lie a few micrometres in each other, or do not: what the pairs say of
// it beside what the triangles say.

#include <gtest/gtest.h>

#include <algorithm>
#include <memory>

#include "haptics/bake/solid.h"
#include "haptics/contact/feature_crossings.h"
#include "haptics/contact/feature_pairs.h"
#include "haptics/math/rotation.h"
#include "haptics/math/split_mix.h"
#include "tests/parts/exact_depth.h"
#include "tests/parts/fits.h"
#include "tests/parts/in_hand.h"

namespace fulcrum::parts {
namespace {

void look_at(const Fit& fit, int poses) {
  constexpr double kSeen = 3e-6, kDeepest = 40e-6;  // m, of the depths that are looked at
  const auto tool = features_of(fit.tool_T), scene = features_of(fit.scene_W);
  FeaturePairs pairs(tool, scene);
  FeatureCrossings crossings(tool, scene);
  const ExactDepth judge(fit.tool_T, fit.scene_W, 0.4e-3);
  double radius = 0;  // m, of the tool
  for (const Vec3& p : fit.tool_T.vertices) radius = std::max(radius, p.norm());
  SplitMix random(5);
  const auto any = [&] { return 2 * random.uniform() - 1; };
  int in = 0, out = 0;
  for (int i = 0; i < poses; ++i) {
    const double size = fit.clearance * (0.5 + 2.5 * random.uniform());
    const Pose X_WT{quaternion_exp(size / radius * Vec3(any(), any(), any())) * fit.X_WT.q,
                    fit.X_WT.p + size * Vec3(any(), any(), any())};
    const double depth = judge.at(X_WT);
    ASSERT_TRUE(pairs.look(X_WT, 100e-6)) << fit.name;
    const bool crossed = crossings.crosses(X_WT);
    if (depth > kSeen && depth < kDeepest) {
      EXPECT_LT(pairs.least_gap(), 0) << fit.name << ' ' << i << ' ' << 1e6 * depth << " um";
      EXPECT_TRUE(crossed) << fit.name << ' ' << i;
      ++in;
    } else if (!crossed) {
      EXPECT_GE(pairs.least_gap(), -1e-9) << fit.name << ' ' << i;
      ++out;
    }
  }
  EXPECT_GT(in, 0) << fit.name;
  EXPECT_GT(out, 0) << fit.name;
}

TEST(FeaturePairsOfParts, SayWhetherTheyAreInEachOther) {
  for (const Fit& fit : fits())
    if (fit.pitch == 0) look_at(fit, 24);
}

TEST(FeaturePairsOfParts, SayWhetherNutsAreInTheirBoltsLong) {
  for (const Fit& fit : fits())
    if (fit.pitch > 0) look_at(fit, 24);
}

}  // namespace
}  // namespace fulcrum::parts
