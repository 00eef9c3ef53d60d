#include "engine/analysis/uniformity/stick_scene.h"

#include <numbers>
#include <vector>

#include "engine/analysis/shapes.h"
#include "haptics/bake/field_bake.h"
#include "haptics/bake/solid.h"
#include "haptics/math/functions.h"

namespace fulcrum::analysis::uniformity {
namespace {

constexpr int kAround = 8;       // points; one of them is lowest
constexpr int kBallSplits = 64;  // its facets lie within 2 um of it
constexpr double kVoxel = 1e-3;  // m; the ball's curvature makes 3 um of it
constexpr double kBand = 8e-3;   // m, deeper than any strike

}  // namespace

StickBodies stick_bodies() {
  std::vector<Vec3> points, normals;
  for (int i = 0; i * kPointSpacing <= kStickLength + 1e-9; ++i) {
    for (int k = 0; k < kAround; ++k) {
      const double angle = 2 * std::numbers::pi * k / kAround;
      const Vec3 outward(0, -math::cos(angle), math::sin(angle));
      points.push_back(Vec3(i * kPointSpacing, 0, 0) + kStickRadius * outward);
      normals.push_back(outward);
    }
  }
  const double area = 2 * std::numbers::pi * kStickRadius * kStickLength / static_cast<double>(points.size());
  const TriangleMesh ball =
      moved(ball_mesh(kBallRadius, kBallSplits), {Quat::Identity(), Vec3(0, -kBallRadius, 0)});
  FieldDesc field;
  field.voxel_m = kVoxel;
  field.band_m = kBand;
  return {std::make_shared<Pointshell>(std::move(*pointshell_from_points(
              points, normals, std::vector<double>(points.size(), area), kPointSpacing))),
          std::make_shared<DistanceField>(std::move(*bake_field(*build_solid(ball), field)))};
}

SceneDesc stick_scene(const StickBodies& bodies, const DeviceDesc& device, const StickTouch& touch,
                      const InertiaCompensationDesc& compensation) {
  SceneDesc scene;
  scene.device = device;
  scene.tool_shell = bodies.stick;
  scene.scene_field = bodies.ball;
  scene.tool.weight = false;
  scene.tool.mass = 0.02;
  scene.tool.inertia_T = Vec3(2e-7, 7e-5, 7e-5).asDiagonal();
  scene.mapping.X_WD.p = Vec3(-touch.place, kStickRadius, 0);
  scene.tool.X_WT_start = scene.mapping.X_WD;
  scene.tool.X_WT_start.p.y() += 0.03;
  scene.contact.response = ContactResponse::direct;
  scene.contact.stiffness = touch.stiffness;
  HoldingPointDesc holding;
  holding.place = touch.held;
  holding.low = 0;
  holding.high = kStickLength;
  holding.measured = false;
  scene.holding_point = holding;
  scene.inertia_compensation = compensation;
  return scene;
}

}  // namespace fulcrum::analysis::uniformity
