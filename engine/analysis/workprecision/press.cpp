#include "engine/analysis/workprecision/press.h"

#include <algorithm>
#include <cmath>

#include "engine/analysis/workprecision/bodies.h"
#include "haptics/loop/run_tick.h"
#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"

namespace fulcrum::analysis::workprecision {
namespace {

constexpr int kPressing = 100, kSettling = 200, kMeasured = 50;  // ticks

struct Response {
  const char* name;
  ContactResponse response;
};
constexpr Response kResponses[] = {{"penalty", ContactResponse::penalty},
                                   {"voxel", ContactResponse::voxel},
                                   {"static", ContactResponse::quasi_static},
                                   {"constraint", ContactResponse::constraint}};

SceneDesc scene(const PressTask& task, ContactResponse response) {
  SceneDesc desc;
  desc.tool.mass = 0.1;
  desc.tool.inertia_T = Mat3::Identity() * 2e-5;
  desc.tool.weight = false;
  desc.velocity.kind = VelocityEstimatorKind::difference;
  desc.coupling = task.coupling;
  desc.integrator = Integrator::implicit_euler;  // contact keeps its stiffness
  desc.contact.response = response;
  desc.contact.stiffness = task.stiffness;
  desc.contact.region_radius = task.region_radius;
  return desc;
}

double size(const Wrench& F, double arm) {
  return math::hypot(F.force.norm(), F.torque.norm() / arm);
}

struct Pressed {
  double mean_square = 0;  // of the felt wrench's error, over its truth
  double cpu_us = 0;       // a tick, while the hand presses in
};

// us a tick, while the hand goes from where the tool is to where it will hold.
double press(World& world, const PressPlace& place, DeviceSample& sample) {
  const Vec3 turn = rotation_vector(place.X_WG.q * place.X_WT_start.q.conjugate());
  const std::int64_t before = thread_cpu_ns();
  for (int i = 1; i <= kPressing; ++i) {
    const double way = static_cast<double>(i) / kPressing;
    sample.X_DH.p = place.X_WT_start.p + way * (place.X_WG.p - place.X_WT_start.p);
    sample.X_DH.q = quaternion_exp(Vec3(way * turn)) * place.X_WT_start.q;
    step(world, sample, {});
  }
  return static_cast<double>(thread_cpu_ns() - before) * 1e-3 / kPressing;
}

// Mean square of the felt wrench's error, over its truth.
double error_while_held(World& world, const PressPlace& place, const DeviceSample& sample, double arm) {
  for (int i = 0; i < kSettling; ++i) step(world, sample, {});
  double mean_square = 0;
  for (int i = 0; i < kMeasured; ++i) {
    const Wrench off = step(world, sample, {}).record.coupling_F_T_W + -place.felt;
    mean_square += math::square(size(off, arm) / size(place.felt, arm)) / kMeasured;
  }
  return mean_square;
}

WorkPoint measure(const std::string& method, double value, SceneDesc desc,
                  const std::vector<PressPlace>& places, double arm) {
  double sum = 0, us = 0;
  for (const PressPlace& place : places) {
    desc.tool.X_WT_start = place.X_WT_start;
    World world = std::move(*World::build(desc));
    DeviceSample sample;
    us += press(world, place, sample);
    sum += error_while_held(world, place, sample, arm);
  }
  const auto n = static_cast<double>(places.size());
  return {method, value, std::sqrt(sum / n), us / n};
}

}  // namespace

CouplingDesc straight_springs() {
  CouplingDesc desc;
  desc.max_force = 1e5;
  desc.max_torque = 1e4;
  return desc;
}

void measure_presses(WorkStudy& study, const PressTask& task) {
  for (const auto& [name, response] : kResponses) {
    const std::vector<PressPlace>& places =
        response == ContactResponse::constraint ? task.rigid : task.springs;
    SceneDesc desc = scene(task, response);
    desc.tool_shell = task.shell;
    for (const auto& field : task.fields) {
      desc.scene_field = field;
      study.points.push_back(measure(name, 1e3 * field->voxel_m(), desc, places, task.arm));
    }
  }
  for (const FacetedBodies& bodies : task.faceted) {
    SceneDesc desc = scene(task, ContactResponse::constraint);
    desc.tool_features = bodies.tool;
    desc.scene_features = bodies.scene;
    study.points.push_back(measure("triangles", 1e3 * bodies.facet, desc, task.rigid, task.arm));
  }
  study.baseline = "voxel";
  measure_orders(study);
}

}  // namespace fulcrum::analysis::workprecision
