// The arms that plate draws, along the expert's taps: between plates, stand and table there is room for them.

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "engine/app/picture/bridge.h"
#include "engine/app/prepare/prepare.h"

namespace fulcrum::test {
namespace {

constexpr double kTip = 12e-3;   // m: what is nearer to the tip may be as near to a plate as the tip is
constexpr double kMin = 1.5e-3;  // m
constexpr float kTable = -0.2F;  // m, y of its top

// Points on the sides of triangles, no farther apart than 2 mm: bars have vertices at their ends alone.
std::vector<glm::vec3> surface_of(const render::Mesh& mesh) {
  std::vector<glm::vec3> points;
  for (std::size_t i = 0; i < mesh.indices.size(); ++i) {
    const glm::vec3& a = mesh.positions[mesh.indices[i]];
    const glm::vec3& b = mesh.positions[mesh.indices[i % 3 == 2 ? i - 2 : i + 1]];
    const int pieces = 1 + static_cast<int>(glm::distance(a, b) / 2e-3F);
    for (int k = 0; k < pieces; ++k)
      points.push_back(a + static_cast<float>(k) / static_cast<float>(pieces) * (b - a));
  }
  return points;
}

TEST(Arm, IsClearOfPlatesStandAndTable) {
  const std::optional<app::Prepared> plate = app::prepare("plate", std::vector<std::string>());
  ASSERT_TRUE(plate);
  const auto visual = scenario::assemble_visual(plate->scenario, plate->models, plate->haptic.scene);
  ASSERT_TRUE(visual) << scenario::to_text(visual.faults());
  app::FrameBridge bridge(visual->desc, plate->scenario, plate->haptic.scene);
  const HandPath path(plate->haptic.hands.front().waypoints);
  ASSERT_EQ(plate->haptic.hands.front().name, "expert");
  const DistanceField& field = *plate->haptic.scene.scene_field;
  const Pose X_TH = plate->haptic.scene.tool.X_HT.inverse();
  double least = 1, least_tip = 1;
  float lowest = 1;
  for (double t = 0; t < path.duration(); t += 0.1) {
    TickRecord record;
    record.X_WT = path.at(t);
    record.X_WH = record.X_WT * X_TH;
    if (field.distance(record.X_WH.p) < 2e-3) continue;  // pressed in, where no hand gets to
    const render::FrameState frame = bridge.frame(record, {}, {}, {}, 0);
    std::size_t movable = 0;
    for (const render::Instance& instance : visual->desc.instances) {
      if (!instance.movable) continue;
      const glm::mat4& X_WM = frame.X_WM[movable++];
      if (instance.follows == 0) continue;
      for (const glm::vec3& p_M : surface_of(visual->desc.meshes[instance.mesh])) {
        const glm::vec4 p = X_WM * glm::vec4(p_M, 1.0F);
        const Vec3 p_W(p.x, p.y, p.z);
        double& of = (p_W - record.X_WH.p).norm() < kTip ? least_tip : least;
        of = std::min(of, field.distance(p_W));
        lowest = std::min(lowest, p.y);
      }
    }
  }
  EXPECT_GT(least, kMin);
  EXPECT_GT(least_tip, 0);
  EXPECT_GT(lowest, kTable + 5e-3F);
}

}  // namespace
}  // namespace fulcrum::test
