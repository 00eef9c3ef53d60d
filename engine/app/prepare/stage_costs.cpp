#include "engine/app/prepare/stage_costs.h"

#include <algorithm>
#include <vector>

#include "haptics/contact/query.h"
#include "haptics/effects/effects.h"
#include "haptics/loop/run_tick.h"
#include "haptics/motion/build_motion.h"
#include "haptics/tool/virtual_coupling.h"
#include "haptics/world/handle_input.h"

namespace fulcrum::app {
namespace {

constexpr double kStretch = 20;  // s of the hand's motion
constexpr std::size_t kSamplesWanted = 2000;

struct TimePoint {
  BodyState tool;
  DeviceSample sample;
  Pose X_WH;
  Wrench coupling_F_T_W;
};

// us per call of f over all time_points; the first pass warms the caches.
template <class F>
double mean_us(const std::vector<TimePoint>& time_points, F&& f) {
  for (const TimePoint& m : time_points) f(m);
  const std::int64_t before = thread_cpu_ns();
  for (const TimePoint& m : time_points) f(m);
  return static_cast<double>(thread_cpu_ns() - before) * 1e-3 / static_cast<double>(time_points.size());
}

// us per call of f, tick after tick: what a query reads lies where the one before left off.
template <class T, class F>
double mean_over(const std::vector<T>& ticks, F&& f) {
  const std::int64_t before = thread_cpu_ns();
  for (const T& tick : ticks) f(tick);
  return static_cast<double>(thread_cpu_ns() - before) * 1e-3 / static_cast<double>(ticks.size());
}

// A difference of two measured times can come out below what it must be.
constexpr double kMin_us = 0.01;

double follow_us(const PlainScene& scene, const std::vector<DeviceSample>& samples) {
  HandleInput input(scene);
  return mean_over(samples, [&input](const DeviceSample& sample) {
    std::uint32_t faults = 0;
    input.follow(sample, faults);
  });
}

EffectTick seen_by_effects(const TickEvent& event, const SceneDesc& scene, HandleInput& input) {
  const TickRecord& record = event.record;
  std::uint32_t faults = 0;
  EffectTick tick;
  tick.tick = record.tick;
  tick.handle = input.follow(event.sample, faults);
  tick.answer.X_WT = record.X_WT;
  tick.answer.coupling_F_T_W = record.coupling_F_T_W;
  tick.answer.contact_F_T_W = record.contact_F_T_W;
  tick.answer.full_torque_T_W = record.coupling_F_T_W.torque;
  tick.p_WH = record.X_WT * scene.tool.X_HT.inverse().p;
  tick.gain = record.force_gain;
  tick.wanted_F_H_D = record.device_F_H_D;
  tick.felt_D = record.device_F_H_D.force;
  return tick;
}

// All that an effect does in a tick.
double use(Effect& effect, const EffectTick& tick) {
  DeviceCommand command;
  EffectRecords records;
  double sum = effect.shape(tick).force.x() + effect.correct(tick).force.x();
  if (const std::optional<Transient> wanted = effect.strike(tick)) sum += wanted->F_H_D.force.x();
  sum += effect.settle(tick, {}).correction_F_H_D.force.x();
  effect.command(tick, tick.gain, false, command);
  effect.record(records);
  return sum;
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
  std::vector<TimePoint> time_points;
  struct Place {
    Pose X_WH, X_WT;
  };
  std::vector<Place> way;        // of every tick
  std::vector<EffectTick> seen;  // likewise, as far as its record tells
  std::vector<Impact> impacts;   // the hardest of each
  std::vector<DeviceSample> samples;
  seen.reserve(ticks);
  impacts.reserve(ticks);
  HandleInput input(scene);
  double whole_us = 0;
  for (std::size_t i = 0; i < ticks; ++i) {
    TickEvent event;
    run_tick(*world, **device, {}, event);
    whole_us += static_cast<double>(event.cpu_ns) * 1e-3 / static_cast<double>(ticks);
    way.push_back({event.record.X_WH, event.record.X_WT});
    samples.push_back(event.sample);
    impacts.push_back(event.record.impact.value_or(ImpactTick()).hardest);
    seen.push_back(seen_by_effects(event, scene, input));
    if (impacts.back().speed > 0) seen.back().impacts = {&impacts.back(), 1};
    if (i % every == 0)
      time_points.push_back({{event.record.X_WT, event.record.V_WT},
                             event.sample,
                             event.record.X_WH,
                             event.record.coupling_F_T_W});
  }

  const RigidBody body(scene.tool.mass, scene.tool.inertia_T);
  ContactQuery query(scene.tool_shell, scene.scene_field);
  VirtualCoupling coupling(scene.coupling, body);
  VelocityEstimator velocity(scene.velocity, scene.tick_s);
  Allocator motors(scene.device, scene.allocation);
  Guard guard(scene.device, scene.tick_s, transient_sources(scene, scene));
  ContactSet set;
  double unused = 0;  // summed up so that no call is optimised away

  std::map<std::string, double> us;
  us["tick"] = whole_us;
  us["coupling"] = mean_us(time_points, [&](const TimePoint& m) {
    unused += coupling.pull(m.X_WH * scene.tool.X_HT, {}, m.tool).force.x();
  });
  const std::unique_ptr<ToolMotion> motion = build_motion(scene);
  const double response_us = mean_over(way, [&](const Place& place) {
    std::uint32_t faults = 0;
    unused += motion->advance(place.X_WH * scene.tool.X_HT, {}, faults).contact_F_T_W.force.x();
  });
  us["response"] = response_us;
  if (coupled(scene.contact.response)) us["response"] -= us["coupling"];
  // A tool with mass queries once a tick. One without looks as often as it moves: its queries are its
  // response's.
  if (!massless(scene.contact.response)) {
    us["query"] = mean_over(way, [&](const Place& place) { query.run(place.X_WT, set); });
    us["integrator"] = mean_us(time_points, [&](const TimePoint& m) {
      const Twist V = body.accelerate(m.tool, m.coupling_F_T_W, scene.tick_s);
      unused += RigidBody::advance(m.tool.X_WT, V, scene.tick_s).p.x();
    });
    us["response"] -= us["query"] + us["integrator"];
  }
  us["estimator"] =
      mean_us(time_points, [&](const TimePoint& m) { unused += velocity.update(m.X_WH).v.x(); });
  us["allocation"] = mean_us(time_points, [&](const TimePoint& m) {
    motors.begin(m.sample.X_DH);
    unused += motors.wrench(m.coupling_F_T_W).force_share;
  });
  us["safety"] = mean_us(time_points, [&](const TimePoint& m) {
    std::uint32_t faults = guard.watch(m.sample, {});
    unused += guard.limit(m.coupling_F_T_W, faults).force.x();
  });
  for (const auto& effect : build_effects(scene, scene))
    us[effect->part().name] = mean_over(seen, [&](const EffectTick& tick) { unused += use(*effect, tick); });
  if (detects_impacts(scene)) {
    ImpactDetector detector(scene.impact, scene.contact.region_radius, scene.scene_field,
                            scene.scene_objects);
    const std::unique_ptr<ToolMotion> again = build_motion(scene);
    const double both_us = mean_over(way, [&](const Place& place) {
      std::uint32_t faults = 0;
      const Pose X_WG = place.X_WH * scene.tool.X_HT;
      unused += again->advance(X_WG, {}, faults).contact_F_T_W.force.x();
      detector.process({.X_WT = place.X_WT, .X_WG = X_WG, .V_WG = {}, .touching = again->touching()});
    });
    us["impacts"] = std::max(both_us - response_us, kMin_us);
  }
  if (scene.holding_point) {
    PlainScene without = scene;
    without.holding_point.reset();
    us["holding point"] = std::max(follow_us(scene, samples) - follow_us(without, samples), kMin_us);
  }
  const auto budget_us = [&](TransientSource source) {
    return mean_us(time_points, [&](const TimePoint& m) {
      std::uint32_t faults = 0;
      unused += guard.limit_transient(source, m.coupling_F_T_W * 0.01, {}, Vec6::Zero(), faults).force.x();
    });
  };
  for (const TransientSource source : transient_sources(scene, scene))
    us[budget_name(source)] = budget_us(source);
  volatile double kept = unused;
  static_cast<void>(kept);
  return us;
}

}  // namespace fulcrum::app
