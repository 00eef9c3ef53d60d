#include "engine/analysis/uniformity/late_compensation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "haptics/device/simulated_device.h"
#include "haptics/world/world.h"

namespace fulcrum::analysis::uniformity {
namespace {

constexpr double kRunLength = 4, kLast = 0.5;  // s
constexpr double kAbove = 5e-3;                // m, where the hand begins
constexpr double kDeep = 4e-3;                 // m, where it wants the stick
constexpr double kNoBudget = 1e3;              // J, that nothing reaches

struct Swing {
  std::vector<double> way;
  double swing = 0, faded_at = -1, least_port = 0;
};

Swing press(SceneDesc scene, const InertiaLoop& loop) {
  Pose above = scene.mapping.X_WD, deep = above;
  above.p.y() += kAbove;
  deep.p.y() -= kDeep;
  scene.tool.X_WT_start = above;
  HandTask task{.path = HandPath({{.X_WT = above, .travel = 0, .dwell = 1}, {.X_WT = deep, .travel = 0.5}}),
                .hand = {},
                .X_HT = scene.tool.X_HT,
                .mapping = scene.mapping};
  task.hand.mass = loop.hand_mass;
  task.hand.stiffness = loop.hand_stiffness;
  task.hand.damping = loop.damping - scene.device.damping;
  SimulatedDevice device({.device = scene.device, .tick_s = scene.tick_s}, std::move(task));
  World world = std::move(*World::build(scene));
  Swing run;
  double low = kAbove, high = -kAbove;
  for (int i = 0; i < static_cast<int>(kRunLength / scene.tick_s); ++i) {
    const double t = i * scene.tick_s;
    const StepResult result = step(world, device.read(), {});
    device.write(result.command);
    const double y = device.X_DH().p.y();
    run.way.push_back(y);
    run.least_port = std::min(run.least_port, result.record.energy_port);
    if (result.record.inertia_compensation->faded && run.faded_at < 0) run.faded_at = t;
    if (t < kRunLength - kLast) continue;
    low = std::min(low, y);
    high = std::max(high, y);
  }
  run.swing = high - low;
  return run;
}

}  // namespace

std::vector<LateRun> study_late_compensation(const StickBodies& bodies, const DeviceDesc& device,
                                             const InertiaLoop& loop, const std::vector<double>& jerks) {
  std::vector<LateRun> runs;
  for (const double jerk : jerks) {
    InertiaCompensationDesc by;
    by.method = InertiaMethod::acceleration;
    by.gain = loop.gain;
    by.filter.jerk = jerk;
    SceneDesc scene =
        stick_scene(bodies, device, {.place = 0, .held = 0, .stiffness = loop.wall_stiffness}, by);
    scene.tick_s = loop.tick_s;
    scene.device.friction = 0;
    scene.device.handle_mass = loop.device_mass;
    const Swing faded = press(scene, loop);
    scene.inertia_compensation->budget = kNoBudget;
    const Swing unfaded = press(scene, loop);
    const double noise = device.encoder_step / std::sqrt(12.0);
    const SteadyFilter filter = steady_filter(kalman_model(jerk, noise, 0, loop.tick_s), loop.tick_s);
    runs.push_back({.jerk = jerk,
                    .lag = filter.lag,
                    .growth = growth(loop, filter),
                    .swing = faded.swing,
                    .swing_unfaded = unfaded.swing,
                    .faded_at = faded.faded_at,
                    .least_port = faded.least_port,
                    .way = faded.way,
                    .way_unfaded = unfaded.way});
  }
  return runs;
}

}  // namespace fulcrum::analysis::uniformity
