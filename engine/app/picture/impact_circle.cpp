#include "engine/app/picture/impact_circle.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/render/turned.h"
#include "engine/scenario/to_glm.h"
#include "haptics/math/functions.h"

namespace fulcrum::app {
namespace {

constexpr std::size_t kPieces = 90;
constexpr float kTube = 0.9e-3F;   // m, its radius
constexpr float kDot = 5.5e-3F;    // m
constexpr float kOverlap = 0.03F;  // of a piece's length, so that no light falls through the bends
constexpr double kFade = 0.5;      // s
constexpr double kNowhere = 1e-6;  // of its size: a transform must not flatten
constexpr std::uint32_t kEveryLayer = ~0U;

// Columns: the axes of a piece, scaled, and its origin.
glm::mat4 affine(const Vec3& x, const Vec3& y, const Vec3& z, const Vec3& p) {
  glm::mat4 M(1.0F);
  const Vec3 columns[] = {x, y, z, p};
  for (int column = 0; column < 4; ++column)
    for (int row = 0; row < 3; ++row) M[column][row] = static_cast<float>(columns[column][row]);
  return M;
}

glm::mat4 nowhere(const Pose& X_WT) {
  return affine(kNowhere * Vec3::UnitX(), kNowhere * Vec3::UnitY(), kNowhere * Vec3::UnitZ(), X_WT.p);
}

// A piece's length is along its z, 1 m of its mesh.
glm::mat4 piece_pose(std::size_t piece, const StruckPlace& struck, const Pose& X_WT, double thickness) {
  const Vec3& axis = struck.axis_T;
  const Vec3 u = axis.unitOrthogonal(), v = axis.cross(u);
  const auto on_circle = [&](std::size_t i) {
    const double angle = 2 * std::numbers::pi * static_cast<double>(i % kPieces) / kPieces;
    return Vec3(struck.centre_T + struck.radius * (math::cos(angle) * u + math::sin(angle) * v));
  };
  const Vec3 from = on_circle(piece), along = on_circle(piece + 1) - from;
  const Vec3 side = axis.cross(along).normalized();
  return affine(X_WT.q * (thickness * side), X_WT.q * (thickness * along.normalized().cross(side)),
                X_WT.q * along, X_WT * from);
}

}  // namespace

std::optional<Error> refuse_impact_circle(const std::string& scenario, const EffectDescs& effects,
                                          const DeviceDesc& device) {
  PlainScene scene;
  scene.device = device;
  if (tells_objects_apart(scene, effects)) return std::nullopt;
  return Error{
      "nothing in '" + scenario +
      "' vibrates at impacts on this device, which `fulcrum explain` has the reason for: leave it out, "
      "or take a scenario that does, as knock does"};
}

std::optional<StruckPlace> struck_place(const TickRecord& record, const Vec3& p_TH, double time) {
  if (!record.impact || record.impact->count == 0) return std::nullopt;
  const std::optional<ImpactCircle> circle = impact_circle(record);
  if (!circle) return std::nullopt;
  const Pose X_TW = record.X_WT.inverse();
  StruckPlace struck{.time = time,
                     .centre_T = p_TH,
                     .axis_T = X_TW.q * circle->axis_W,
                     .radius = circle->radius,
                     .p_T = X_TW * record.impact->hardest.p_W};
  constexpr double same = 1e-9;  // m
  if (std::abs((*struck.p_T - struck.centre_T).norm() - struck.radius) > same) struck.p_T.reset();
  return struck;
}

void add_impact_circle(render::VisualDesc& desc) {
  const std::size_t material = desc.materials.size();
  desc.materials.push_back({"circle of confusion", {1.0F, 0.42F, 0.02F}, 0.0F, 0.6F});
  render::Mesh tube, dot;
  tube.name = dot.name = "impact";
  const render::Turned profile[] = {{kTube, -kOverlap}, {kTube, 1.0F + kOverlap}};
  render::add_turned(tube, {}, {0.0F, 0.0F, 1.0F}, profile);
  render::add_ball(dot, {}, kDot);
  for (std::size_t piece = 0; piece <= kPieces; ++piece) {
    render::Instance instance;
    instance.mesh = desc.meshes.size() + (piece < kPieces ? 0 : 1);
    instance.material = material;
    instance.name = "impact";
    instance.X_WM = nowhere({});
    instance.movable = true;
    instance.casts_shadow = false;
    instance.layers = kEveryLayer;
    instance.follows = scenario::kFollowsImpactCircle + piece;
    desc.instances.push_back(std::move(instance));
  }
  desc.meshes.push_back(std::move(tube));
  desc.meshes.push_back(std::move(dot));
}

glm::mat4 impact_circle_pose(std::size_t body, const std::optional<StruckPlace>& struck, const Pose& X_WT,
                             double time) {
  const double left = struck ? struck->time + kSeen + kFade - time : 0;
  if (!(left > 0) || time < struck->time) return nowhere(X_WT);
  const double thickness = std::min(1.0, left / kFade);
  const std::size_t piece = body - scenario::kFollowsImpactCircle;
  if (piece < kPieces) {
    const bool circle = !struck->axis_T.isZero() && struck->radius > 0;
    return circle ? piece_pose(piece, *struck, X_WT, thickness) : nowhere(X_WT);
  }
  if (!struck->p_T) return nowhere(X_WT);
  const glm::mat4 X = scenario::to_glm({X_WT.q, X_WT * *struck->p_T});
  const auto s = static_cast<float>(thickness);
  return {X[0] * s, X[1] * s, X[2] * s, X[3]};
}

}  // namespace fulcrum::app
