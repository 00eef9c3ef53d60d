#include "tests/bench/piping_tick.h"

#include <algorithm>
#include <stdexcept>
#include <vector>

#include "haptics/bake/field_bake.h"
#include "haptics/bake/pointshell_bake.h"
#include "haptics/contact/query.h"
#include "haptics/device/simulated_device.h"
#include "haptics/motion/motion_limit.h"
#include "haptics/safety/faults.h"
#include "haptics/world/world.h"
#include "tests/bench/contact_workload.h"
#include "tests/bench/cpu_time.h"
#include "tests/bench/query_cost.h"
#include "tools/content/mesh/mass.h"
#include "tools/content/piping/spanner.h"

namespace fulcrum::bench {
namespace {

constexpr double kWarm_s = 0.5;

template <class T>
T expect(Result<T> result) {
  if (!result) throw std::runtime_error(result.error().sentence);
  return std::move(*result);
}

Pose pose(const Vec3& p, double w, double x, double y, double z) {
  return {Quat(w, x, y, z).normalized(), p};
}

// The beginning of content/scenarios/piping/clumsy.yaml.
HandPath clumsy_path() {
  const Vec3 start(-0.056486, 0.087343, 0.28277), nut(-0.033486, -0.027656, 0.04777);
  const Pose at_nut = pose(nut, 0.541675, -0.612372, 0.454519, 0.353553);
  const Pose twisted = pose(nut, 0.816035, -0.04999, 0.571394, -0.071394);
  return HandPath({{pose(start, 0.541675, -0.612372, 0.454519, 0.353553), 0, 0.5},
                   {at_nut, 4, 2},
                   {twisted, 0.7, 0},
                   {pose(nut, 0.612372, 0.541675, 0.353553, -0.454519), 0.7, 0.4},
                   {twisted, 0.7, 0},
                   {at_nut, 0.7, 1}});
}

DeviceDesc phantom_like() {
  DeviceDesc device;  // whose figures are those of content/devices/phantom_like.yaml
  device.kinematics = Kinematics::arms;
  const auto joint = [](const char* name, const Vec3& axis_K, const Vec3& point_K, double low, double high) {
    return JointDesc{
        .name = name, .axis_K = axis_K, .point_K = point_K, .low = low, .high = high, .max_torque = 1.2};
  };
  ArmDesc arm{.name = "arm",
              .joints = {joint("yaw", Vec3::UnitY(), Vec3::Zero(), -1.2, 1.2),
                         joint("shoulder", -Vec3::UnitX(), Vec3::Zero(), -0.9, 1.5),
                         joint("elbow", -Vec3::UnitX(), {0, 0, 0.14}, -1.5, 1.5)},
              .end_K = {0, -0.14, 0.14}};
  arm.joints[2].through_parallelogram = true;
  device.mechanism.arms = {std::move(arm)};
  return device;
}

SceneDesc piping_scene(const Solid& plant, const Solid& tool) {
  SceneDesc scene;
  scene.tool_shell = std::make_shared<const Pointshell>(
      expect(bake_pointshell(tool, {.spacing_m = 1.5e-3, .deviation = 50e-6})));
  scene.scene_field =
      std::make_shared<const DistanceField>(expect(bake_field(plant, {.voxel_m = 0.66e-3, .band_m = 2e-3})));
  scene.scene_edges = std::make_shared<const Pointshell>(expect(bake_edges(plant, {.spacing_m = 0.5e-3})));
  scene.tool_field = std::make_shared<const DistanceField>(expect(bake_field(tool, {})));
  const content::MassProperties mass = mass_properties(content::spanner_solid(), content::steel_density);
  scene.tool.mass = mass.mass;
  scene.tool.inertia_T = mass.inertia;
  scene.tool.X_HT = pose({0, 0, -0.05}, 0.5, -0.5, 0.5, 0.5);
  scene.tool.X_WT_start = clumsy_path().at(0);
  scene.contact = {
      .response = ContactResponse::constraint, .stiffness = 40000, .dissipation = 20, .region_radius = 0.012};
  scene.integrator = Integrator::implicit_euler;
  scene.coupling = {800, 1.5, 1, 6, 0.3};
  scene.velocity = {.kind = VelocityEstimatorKind::low_pass, .cutoff_Hz = 60};
  scene.mapping.X_WD.p = Vec3(0, 0.06, 0.2);
  scene.mapping.position_scale = 2.5;
  scene.mapping.force_scale = 0.4;
  scene.device = phantom_like();
  return scene;
}

SimulatedDevice device_of(const SceneDesc& scene) {
  HandTask task{.path = clumsy_path(), .hand = {}, .X_HT = scene.tool.X_HT, .mapping = scene.mapping};
  const Vec3 weight_W(0, -tool_weight(scene.tool), 0);
  task.carried_D = -scene.mapping.wrench_in_device({weight_W, Vec3::Zero()}).force;
  return {{.device = scene.device, .tick_s = scene.tick_s}, std::move(task)};
}

}  // namespace

TickCost cost_of_piping_ticks() {
  const Solid plant = whole_plant(), tool = make_workload().tool;
  const double before = cpu_s(CLOCK_PROCESS_CPUTIME_ID);
  const SceneDesc scene = piping_scene(plant, tool);
  TickCost cost{};
  cost.bake_cpu_s = cpu_s(CLOCK_PROCESS_CPUTIME_ID) - before;
  cost.field_MB = 1e-6 * static_cast<double>(scene.scene_field->bytes());
  cost.shell_points = scene.tool_shell->size();

  World world = expect(World::build(scene));
  SimulatedDevice device = device_of(scene);
  ContactQuery query(scene.tool_shell, scene.scene_field);
  const double reach = std::min(2 * motion_allowance(*scene.scene_field), scene.scene_field->band_m());
  ContactSet near;
  touch(*scene.scene_field);
  touch(*scene.tool_field);
  std::vector<double> us, limited_us;
  const auto ticks = static_cast<int>(clumsy_path().duration() / scene.tick_s);
  for (int tick = 0; tick < ticks; ++tick) {
    const DeviceSample sample = device.read();
    StepResult result;
    const double taken = cpu_us([&] { result = step(world, sample, {}); });
    device.write(result.command);
    if (result.record.stopped) throw std::runtime_error("a fault stopped the piping scene");
    if (result.record.regions == 0 || tick * scene.tick_s < kWarm_s) continue;
    us.push_back(taken);
    if ((result.record.faults & kMotionLimited) != 0) limited_us.push_back(taken);
    cost.regions += result.record.regions;
    query.run(result.record.X_WT, near, reach);
    cost.near_points += static_cast<double>(near.contacts().size());
  }
  if (us.empty()) throw std::runtime_error("the hand in the piping scene met nothing");
  cost.ticks = us.size();
  cost.regions /= static_cast<double>(us.size());
  cost.near_points /= static_cast<double>(us.size());
  cost.limited_ticks = limited_us.size();
  if (!limited_us.empty()) cost.limited_median_us = quantile(limited_us, 0.5);
  cost.median_us = quantile(us, 0.5);
  cost.p99_us = quantile(us, 0.99);
  return cost;
}

}  // namespace fulcrum::bench
