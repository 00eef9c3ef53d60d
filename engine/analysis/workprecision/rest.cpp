// A roller at rest across a knife edge: what lies between a tool's points, and what keeps it out.

#include <cmath>
#include <numbers>
#include <random>

#include "engine/analysis/shapes.h"
#include "engine/analysis/workprecision/bodies.h"
#include "engine/analysis/workprecision/press.h"
#include "engine/analysis/workprecision/workprecision.h"
#include "haptics/bake/pointshell_bake.h"
#include "haptics/bake/solid.h"
#include "haptics/loop/run_tick.h"
#include "haptics/math/rotation.h"

namespace fulcrum::analysis::workprecision {
namespace {

constexpr double kTubeRadius = 4e-3, kPressed = 1e-3;  // m
constexpr double kDeviation = 50e-6, kEdges = 0.5e-3;  // m
constexpr int kLowering = 60, kResting = 100;          // ticks

// Along x, its edge at y = 0, 60 degrees sharp.
TriangleMesh knife_mesh() {
  TriangleMesh mesh;
  for (const double x : {-0.03, 0.03}) {
    mesh.vertices.emplace_back(x, 0, 0);
    mesh.vertices.emplace_back(x, -0.0173, 0.01);
    mesh.vertices.emplace_back(x, -0.0173, -0.01);
  }
  mesh.triangles = {{0, 1, 2}, {3, 5, 4}, {0, 3, 4}, {0, 4, 1}, {1, 4, 5}, {1, 5, 2}, {2, 5, 3}, {2, 3, 0}};
  return mesh;
}

struct ShellMethod {
  const char* name;
  double deviation;  // m
  bool edges;
};

struct Rest {
  double mean_square = 0;
  double cpu_us = 0;  // a tick, while the hand presses
};

Rest rest(const SceneDesc& desc) {
  World world = std::move(*World::build(desc));
  DeviceSample sample;
  const Pose& start = desc.tool.X_WT_start;
  sample.X_DH = start;
  const double lowest = kTubeRadius - kPressed;
  const std::int64_t before = thread_cpu_ns();
  for (int i = 1; i <= kLowering; ++i) {
    sample.X_DH.p.y() = start.p.y() + (lowest - start.p.y()) * i / kLowering;
    step(world, sample, {});
  }
  const double us = static_cast<double>(thread_cpu_ns() - before) * 1e-3 / kLowering;
  Vec3 felt = Vec3::Zero();
  for (int i = 0; i < kResting; ++i) felt = step(world, sample, {}).record.coupling_F_T_W.force;
  // Pressed beside its middle the roller tips a little.
  const double aside = start.p.z(), k = desc.coupling.stiffness, k_R = desc.coupling.angular_stiffness;
  const double truth = kPressed / (1 / k + aside * aside / k_R);
  return {(felt - Vec3(0, -truth, 0)).squaredNorm() / (truth * truth), us};
}

}  // namespace

WorkStudy study_rest(bool quick) {
  WorkStudy study{
      "roller on a knife edge",
      "A roller of 4 mm radius lies across a knife edge and is pressed 1 mm beyond it, under the response "
      "constraint, at places and rolls that share nothing with its points: F = x / (1 / k + a² / k_R), where "
      "a is how far the edge is from its middle. Between the points the edge goes in, and the roller's own "
      "roundness stands out. Even: points at that spacing. Deviation: more of them, so that the surface "
      "stands out by at most 0.05 mm (shell.deviation). Edges: and the "
      "knife's edge, in points 0.5 mm apart, against a field of the roller (contact.edges). Triangles: "
      "contact.surface, on a roller of so many facets, whose roundness is what it errs by, of order 2, down "
      "to 0.002, which the truth leaves out: where the roller tips, what it is pushed by leans, too. "
      "The error is root mean square over the places, of the truth; the work is a tick while the hand "
      "presses in.",
      "spacing of points, or facet (mm)",
      "",
      {},
      {}};
  const Solid roller = std::move(*build_solid(tube_mesh(2e-3, kTubeRadius, 30e-3, quick ? 64 : 256)));
  const Solid knife = std::move(*build_solid(knife_mesh()));
  SceneDesc desc;
  desc.tool.mass = 0.1;
  desc.tool.inertia_T = Mat3::Identity() * 2e-5;
  desc.tool.weight = false;
  desc.coupling = straight_springs();
  desc.velocity.kind = VelocityEstimatorKind::difference;
  desc.contact.response = ContactResponse::constraint;
  desc.scene_field = field_of(knife.mesh, 0.5e-3);
  const auto edges = std::make_shared<Pointshell>(std::move(*bake_edges(knife, {.spacing_m = kEdges})));
  const auto tool_field = field_of(roller.mesh, 0.5e-3);

  const int places = quick ? 8 : 40;
  const auto measure = [&](const char* method, double value_mm) {
    std::mt19937_64 random(9);  // the same places for all
    std::uniform_real_distribution<double> aside(-5e-3, 5e-3), roll(-std::numbers::pi, std::numbers::pi);
    Rest sum;
    for (int i = 0; i < places; ++i) {
      const Quat rolled = quaternion_exp(Vec3(0, 0, roll(random)));
      desc.tool.X_WT_start = {rolled, Vec3(0, kTubeRadius + 1e-3, aside(random))};
      const Rest one = rest(desc);
      sum.mean_square += one.mean_square / places;
      sum.cpu_us += one.cpu_us / places;
    }
    study.points.push_back({method, value_mm, std::sqrt(sum.mean_square), sum.cpu_us});
  };
  const double none = PointshellDesc{}.deviation;
  for (const ShellMethod& method :
       {ShellMethod{"even", none, false}, ShellMethod{"deviation", kDeviation, false},
        ShellMethod{"edges", kDeviation, true}}) {
    desc.scene_edges = method.edges ? edges : nullptr;
    desc.tool_field = method.edges ? tool_field : nullptr;
    for (const double spacing_mm :
         quick ? std::vector{2.0, 1.0} : std::vector{3.0, 2.0, 1.4, 1.0, 0.7, 0.5}) {
      desc.tool_shell = std::make_shared<Pointshell>(std::move(
          *bake_pointshell(roller, {.spacing_m = 1e-3 * spacing_mm, .deviation = method.deviation})));
      measure(method.name, spacing_mm);
    }
  }
  desc.tool_shell = nullptr;
  desc.scene_field = nullptr;
  desc.scene_edges = nullptr;
  desc.tool_field = nullptr;
  desc.scene_features = features_of(knife.mesh);
  for (const int sides : quick ? std::vector{16, 64} : std::vector{16, 32, 64, 128, 256}) {
    desc.tool_features = features_of(tube_mesh(2e-3, kTubeRadius, 30e-3, sides));
    measure("triangles", 2e3 * std::numbers::pi * kTubeRadius / sides);
  }
  measure_orders(study);
  return study;
}

}  // namespace fulcrum::analysis::workprecision
