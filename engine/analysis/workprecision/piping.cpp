// The shipped scene, which nothing describes in closed form: its own finest field and finest points are the
// truth.

#include <algorithm>
#include <cmath>

#include "engine/analysis/best_time.h"
#include "engine/analysis/workprecision/bodies.h"
#include "engine/analysis/workprecision/workprecision.h"
#include "haptics/bake/pointshell_bake.h"
#include "haptics/bake/solid.h"
#include "haptics/contact/penalty.h"
#include "haptics/contact/query.h"
#include "haptics/contact/voxel_query.h"
#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"

namespace fulcrum::analysis::workprecision {
namespace {

constexpr double kLargest = 0.15;  // m: pipes that only pass by are left out
constexpr double kNear = 40e-3;    // m: what lies farther from where the tool touches is left out
constexpr double kMoved = 25e-3;   // m
constexpr double kTurned = 0.02;   // rad
constexpr double kArm = 20e-3;     // m: a torque counts by its force at about the ring's radius
constexpr double kDeepest = 0.6e-3, kShallowest = 0.1e-3;  // m

std::shared_ptr<const Pointshell> shell_of(const Solid& tool, double spacing) {
  PointshellDesc desc;
  desc.spacing_m = spacing;
  return std::make_shared<Pointshell>(std::move(*bake_pointshell(tool, desc)));
}

// The components of the scene that lie about where the tool touches it: the rest would only be baked.
TriangleMesh near_parts(const Solid& scene, const Vec3& p_WC) {
  TriangleMesh parts;
  parts.vertices = scene.mesh.vertices;
  for (const SolidComponent& component : scene.components) {
    if (component.bounds.diagonal().norm() > kLargest || component.bounds.exteriorDistance(p_WC) > kNear)
      continue;
    const auto first = scene.mesh.triangles.begin() + component.first_triangle;
    parts.triangles.insert(parts.triangles.end(), first, first + component.triangle_count);
  }
  return parts;
}

// Where the tool touches, near X_WT.
std::vector<Pose> touching_poses(ContactQuery query, const Pose& X_WT, std::size_t wanted) {
  std::mt19937_64 random(4);
  std::uniform_real_distribution<double> share(0, 1);
  ContactSet set;
  std::vector<Pose> poses;
  for (int tries = 0; tries < 100'000 && poses.size() < wanted; ++tries) {
    Vec3 step = random_direction(random);
    step *= kMoved * share(random);
    Vec3 turn = random_direction(random);
    turn *= kTurned * share(random);
    const Pose tried{quaternion_exp(turn) * X_WT.q, X_WT.p + step};
    query.run(tried, set);
    if (set.depth_max() > kShallowest && set.depth_max() < kDeepest) poses.push_back(tried);
  }
  return poses;
}

double size(const Wrench& F) {
  return math::hypot(F.force.norm(), F.torque.norm() / kArm);
}

struct ResponseCost {
  std::vector<Wrench> wrenches;
  double cpu_us = 0;  // a pose
};

template <class Query>
ResponseCost feel(Query query, const std::vector<Pose>& poses) {
  ContactDesc desc;
  desc.dissipation = 0;
  PenaltyResponse response(desc, RigidBody(0.15, Mat3::Identity() * 1e-4), 1e-3, Integrator::implicit_euler);
  ContactSet set;
  ResponseCost felt;
  const double us = best_us([&] {
    felt.wrenches.clear();
    for (const Pose& X_WT : poses) {
      query.run(X_WT, set);
      felt.wrenches.push_back(response.push(set, {X_WT, {}}).F_T_W);
    }
  });
  felt.cpu_us = us / static_cast<double>(poses.size());
  return felt;
}

double error(const ResponseCost& felt, const ResponseCost& truth) {
  double off = 0, all = 0;
  for (std::size_t i = 0; i < truth.wrenches.size(); ++i) {
    off += math::square(size(felt.wrenches[i] + -truth.wrenches[i]));
    all += math::square(size(truth.wrenches[i]));
  }
  return std::sqrt(off / all);
}

}  // namespace

std::vector<WorkStudy> study_piping(const PipingParts& piping, bool quick) {
  const std::string how =
      " The error is that of force and torque on the tool (a torque by its force at 20 mm), root mean square "
      "over the poses, of the truth's; the work is the query and the response at one pose.";
  WorkStudy fields{
      "piping, field",
      "The ring spanner at its nut behind the pipes, moved and turned at random, 100 times, to where it is "
      "0.1 to 0.6 mm inside nut, bolts or flange: edges, corners, several contacts at once. "
      "Nothing gives the force in "
      "closed form, so the scene is its own truth: a field of 0.25 mm as 32-bit numbers, under "
      "the same points, 1 mm apart. What lies about the nut is baked, not the pipes. Edges round off by a "
      "part of a "
      "voxel, so order 1 is what theory promises." +
          how,
      "voxel (mm)",
      "",
      {{"distance field", 1}},
      {},
      "classic voxels"};
  WorkStudy points{
      "piping, points",
      "The same poses over the same field of 0.5 mm, under points of several spacings; the truth "
      "is the finest, 0.35 mm apart." +
          how,
      "spacing of points (mm)",
      "",
      {},
      {},
      "classic voxels"};
  const Solid tool = std::move(*build_solid(piping.tool_T));
  const Solid scene = std::move(*build_solid(piping.scene_W));
  const auto shell = shell_of(tool, 1e-3);
  const TriangleMesh parts = near_parts(scene, piping.X_WT * piping.p_TC);
  if (parts.triangles.empty()) return {};
  const auto exact = field_of(parts, quick ? 0.5e-3 : 0.25e-3, FieldFormat::float32);
  const std::vector<Pose> poses = touching_poses(ContactQuery(shell, exact), piping.X_WT, quick ? 20 : 100);
  if (poses.empty()) return {};

  const auto compare = [&](WorkStudy& study, const std::vector<double>& values, const ResponseCost& truth,
                           const auto& at) {
    std::vector<WorkPoint> classic;
    for (const double value : values) {
      const auto [points_T, field] = at(1e-3 * value);
      const ResponseCost ours = feel(ContactQuery(points_T, field), poses);
      const ResponseCost voxels = feel(VoxelQuery(points_T, field), poses);
      study.points.push_back({"distance field", value, error(ours, truth), ours.cpu_us});
      classic.push_back({"classic voxels", value, error(voxels, truth), voxels.cpu_us});
    }
    study.points.insert(study.points.end(), classic.begin(), classic.end());
    measure_orders(study);
  };
  compare(fields, quick ? std::vector{1.3, 0.9} : std::vector{0.66, 0.5, 0.4},
          feel(ContactQuery(shell, exact), poses),
          [&](double voxel) { return std::pair(shell, field_of(parts, voxel)); });
  const auto field = field_of(parts, 0.5e-3);
  compare(points, quick ? std::vector{2.0, 1.4} : std::vector{3.0, 2.1, 1.5, 1.0, 0.7},
          feel(ContactQuery(shell_of(tool, quick ? 0.7e-3 : 0.35e-3), field), poses),
          [&](double spacing) { return std::pair(shell_of(tool, spacing), field); });
  return {std::move(fields), std::move(points)};
}

}  // namespace fulcrum::analysis::workprecision
