// Parts that fit, with the faults that exporters leave in them: mended, they touch each other where the sound
// ones do.

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <memory>
#include <string>

#include "haptics/bake/solid.h"
#include "haptics/contact/feature_crossings.h"
#include "haptics/contact/feature_pairs.h"
#include "haptics/math/rotation.h"
#include "haptics/math/split_mix.h"
#include "tests/parts/exported.h"
#include "tests/parts/fits.h"

namespace fulcrum::parts {
namespace {

struct ExportFault {
  std::string name, told;  // what a note says of it; none: nothing is wrong with it
  std::function<TriangleMesh(const TriangleMesh&)> make;
};

std::vector<ExportFault> export_faults() {
  const auto cut = [](const TriangleMesh& mesh) { return with_t_junctions(mesh, 0.3, 3, false, 3); };
  return {{"T-junctions", "Edges have been cut", cut},
          {"T-junctions closed by slivers", "without height",
           [](const TriangleMesh& mesh) { return with_t_junctions(mesh, 0.3, 3, true, 3); }},
          {"faces apart", "", [](const TriangleMesh& mesh) { return face_by_face(mesh, 0, 3); }},
          {"faces that do not quite meet", "Cracks narrower",
           [](const TriangleMesh& mesh) { return face_by_face(mesh, 50e-9, 3); }},
          {"repeats", "left out", [](const TriangleMesh& mesh) { return repeating(mesh, 0.2, 3); }},
          {"inside out", "inside out", [](const TriangleMesh& mesh) { return turned(mesh, 1, 3); }},
          {"some triangles turned", "wound against the rest",
           [](const TriangleMesh& mesh) { return turned(mesh, 0.3, 3); }},
          {"all of it", "Edges have been cut", [cut](const TriangleMesh& mesh) {
             return turned(repeating(face_by_face(cut(mesh), 20e-9, 3), 0.1, 3), 0.2, 3);
           }}};
}

std::shared_ptr<const FeatureMesh> features(const Solid& solid) {
  return std::make_shared<const FeatureMesh>(solid.mesh, solid.neighbours);
}

bool tells(const Solid& solid, const std::string& words) {
  for (const std::string& note : solid.notes)
    if (note.find(words) != std::string::npos) return true;
  return words.empty();
}

void export_and_mend(const Fit& fit) {
  constexpr int kPoses = 30;
  constexpr double kSame = 0.3e-6;  // m: twice what faces that do not meet are off by
  const Result<Solid> tool = build_solid(fit.tool_T), scene = build_solid(fit.scene_W);
  ASSERT_TRUE(tool && scene) << fit.name;
  FeaturePairs sound(features(*tool), features(*scene));
  FeatureCrossings sound_crossings(features(*tool), features(*scene));
  double radius = 0;  // m, of the tool
  for (const Vec3& p : fit.tool_T.vertices) radius = std::max(radius, p.norm());
  for (const ExportFault& fault : export_faults()) {
    const Result<Solid> mended_tool = build_solid(fault.make(fit.tool_T)),
                        mended_scene = build_solid(fault.make(fit.scene_W));
    ASSERT_TRUE(mended_tool) << fit.name << ", " << fault.name << ": " << mended_tool.error().sentence;
    ASSERT_TRUE(mended_scene) << fit.name << ", " << fault.name << ": " << mended_scene.error().sentence;
    EXPECT_TRUE(tells(*mended_tool, fault.told)) << fit.name << ", " << fault.name;
    EXPECT_TRUE(tells(*mended_scene, fault.told)) << fit.name << ", " << fault.name;
    FeaturePairs mended(features(*mended_tool), features(*mended_scene));
    FeatureCrossings mended_crossings(features(*mended_tool), features(*mended_scene));
    SplitMix random(5);
    const auto any = [&] { return 2 * random.uniform() - 1; };
    int apart = 0;
    for (int i = 0; i < kPoses; ++i) {
      const double size = fit.clearance * (0.2 + 2 * random.uniform());
      const Pose X_WT{quaternion_exp(size / radius * Vec3(any(), any(), any())) * fit.X_WT.q,
                      fit.X_WT.p + size * Vec3(any(), any(), any())};
      ASSERT_TRUE(sound.look(X_WT, 100e-6) && mended.look(X_WT, 100e-6)) << fit.name;
      // Of parts in each other it depends on where edges run which pairs there are.
      if (sound_crossings.crosses(X_WT) || !std::isfinite(sound.least_gap())) continue;
      ++apart;
      EXPECT_FALSE(mended_crossings.crosses(X_WT) && sound.least_gap() > kSame)
          << fit.name << ", " << fault.name;
      EXPECT_NEAR(mended.least_gap(), sound.least_gap(), kSame)
          << fit.name << ", " << fault.name << ", pose " << i;
    }
    EXPECT_GT(apart, 0) << fit.name;
  }
}

TEST(ExportedParts, TouchWhereSoundOnesDo) {
  for (const Fit& fit : fits())
    if (fit.pitch == 0 && fit.clearance > 0) export_and_mend(fit);
}

TEST(ExportedParts, NutsTouchWhereSoundOnesDoLong) {
  for (const Fit& fit : fits())
    if (fit.pitch != 0) export_and_mend(fit);
}

}  // namespace
}  // namespace fulcrum::parts
