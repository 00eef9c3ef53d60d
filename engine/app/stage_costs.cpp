#include "engine/app/stage_costs.h"

#include <algorithm>
#include <vector>

#include "haptics/contact/query.h"
#include "haptics/loop/run_tick.h"
#include "haptics/motion/build_motion.h"
#include "haptics/tool/virtual_coupling.h"
#include "haptics/world/build_effects.h"

namespace fulcrum::app {
namespace {

constexpr double kStretch = 20;  // s of the hand's motion
constexpr std::size_t kSamplesWanted = 2000;

struct Moment {
  BodyState tool;
  DeviceSample sample;
  Pose X_WH;
  Wrench coupling_F_T_W;
};

// us per call of f over all moments; the first pass warms the caches.
template <class F>
double mean_us(const std::vector<Moment>& moments, F&& f) {
  for (const Moment& m : moments) f(m);
  const std::int64_t before = thread_cpu_ns();
  for (const Moment& m : moments) f(m);
  return static_cast<double>(thread_cpu_ns() - before) * 1e-3 / static_cast<double>(moments.size());
}

}  // namespace

Result<std::map<std::string, double>> measure_stages(const Prepared& prepared, const std::string& hand) {
  const SceneDesc& scene = prepared.haptic.scene;
  Result<World> world = World::build(scene);
  if (!world) return world.error();
  Result<std::unique_ptr<SimulatedDevice>> device = simulated_device(prepared, hand);
  if (!device) return device.error();

  const auto ticks =
      static_cast<std::size_t>(std::min(kStretch, prepared.scenario.time_limit) / scene.tick_s);
  const std::size_t every = std::max<std::size_t>(1, ticks / kSamplesWanted);
  std::vector<Moment> moments;
  struct Place {
    Pose X_WH, X_WT;
  };
  std::vector<Place> way;  // of every tick
  double whole_us = 0;
  for (std::size_t i = 0; i < ticks; ++i) {
    TickEvent event;
    run_tick(*world, **device, {}, event);
    whole_us += static_cast<double>(event.cpu_ns) * 1e-3 / static_cast<double>(ticks);
    way.push_back({event.record.X_WH, event.record.X_WT});
    if (i % every == 0)
      moments.push_back({{event.record.X_WT, event.record.V_WT},
                         event.sample,
                         event.record.X_WH,
                         event.record.coupling_F_T_W});
  }

  const RigidBody body(scene.tool.mass, scene.tool.inertia_T);
  ContactQuery query(scene.tool_shell, scene.scene_field);
  VirtualCoupling coupling(scene.coupling, body);
  VelocityEstimator velocity(scene.velocity, scene.tick_s);
  Allocator motors(scene.device, scene.allocation);
  Guard guard(scene.device, scene.tick_s, transient_sources(scene));
  std::optional<TorqueSubstitution> torque = build_torque_substitution(scene);
  ContactSet set;
  double unused = 0;  // summed up so that no call is optimised away

  std::map<std::string, double> us;
  us["tick"] = whole_us;
  us["coupling"] = mean_us(moments, [&](const Moment& m) {
    unused += coupling.pull(m.X_WH * scene.tool.X_HT, {}, m.tool).force.x();
  });
  // Tick after tick, since what a query reads lies where the one before left off.
  const auto mean_over_ticks = [&way](const auto& f) {
    const std::int64_t before = thread_cpu_ns();
    for (const Place& place : way) f(place);
    return static_cast<double>(thread_cpu_ns() - before) * 1e-3 / static_cast<double>(way.size());
  };
  const std::unique_ptr<ToolMotion> motion = build_motion(scene);
  us["response"] = mean_over_ticks([&](const Place& place) {
    std::uint32_t faults = 0;
    unused += motion->advance(place.X_WH * scene.tool.X_HT, {}, faults).contact_F_T_W.force.x();
  });
  if (coupled(scene.contact.response)) us["response"] -= us["coupling"];
  // A tool with mass queries once a tick. One without looks as often as it moves: its queries are its
  // response's.
  if (!massless(scene.contact.response)) {
    us["query"] = mean_over_ticks([&](const Place& place) { query.run(place.X_WT, set); });
    us["integrator"] = mean_us(moments, [&](const Moment& m) {
      const Twist V = body.accelerate(m.tool, m.coupling_F_T_W, scene.tick_s);
      unused += RigidBody::advance(m.tool.X_WT, V, scene.tick_s).p.x();
    });
    us["response"] -= us["query"] + us["integrator"];
  }
  us["estimator"] = mean_us(moments, [&](const Moment& m) { unused += velocity.update(m.X_WH).v.x(); });
  us["allocation"] = mean_us(moments, [&](const Moment& m) {
    motors.begin(m.sample.X_DH);
    unused += motors.wrench(m.coupling_F_T_W).force_share;
  });
  us["safety"] = mean_us(moments, [&](const Moment& m) {
    std::uint32_t faults = guard.watch(m.sample, {});
    unused += guard.limit(m.coupling_F_T_W, faults).force.x();
  });
  if (torque) {
    us["torque substitution"] = mean_us(moments, [&](const Moment& m) {
      TorqueSubstitution::Tick tick;
      tick.contact_torque = -m.coupling_F_T_W.torque;
      tick.coupling_F_T_W = m.coupling_F_T_W;
      unused += torque->process(tick).vibration_D.x();
    });
  }
  const auto budget_us = [&](TransientSource source) {
    return mean_us(moments, [&](const Moment& m) {
      std::uint32_t faults = 0;
      unused += guard.limit_transient(source, m.coupling_F_T_W * 0.01, {}, Vec6::Zero(), faults).force.x();
    });
  };
  if (guard.budget(TransientSource::torque_substitution))
    us["transient budget"] = budget_us(TransientSource::torque_substitution);
  if (guard.budget(TransientSource::impact_vibration))
    us["impact budget"] = budget_us(TransientSource::impact_vibration);
  volatile double kept = unused;
  static_cast<void>(kept);
  return us;
}

}  // namespace fulcrum::app
