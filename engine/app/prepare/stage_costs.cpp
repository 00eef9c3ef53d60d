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

constexpr double kLongest = 20;  // s of the hand's motion
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

struct Place {
  Pose X_WH, X_WT;
};

// A stretch of the scenario's motion, as the parts of the tick see it.
struct Stretch {
  double tick_us = 0;            // of a whole tick
  std::vector<TimePoint> times;  // every so many ticks
  std::vector<Place> places;     // of every tick
  std::vector<DeviceSample> samples;
  std::vector<Impact> impacts;  // the hardest of each tick
  std::vector<EffectTick>
      effects;  // what each saw, as far as the tick's record tells; it points into impacts
};

Stretch run_stretch(World& world, SimulatedDevice& device, std::size_t ticks) {
  const SceneDesc& scene = world.desc();
  const std::size_t every = std::max<std::size_t>(1, ticks / kSamplesWanted);
  Stretch stretch;
  stretch.impacts.reserve(ticks);
  HandleInput input(scene);
  for (std::size_t i = 0; i < ticks; ++i) {
    TickEvent event;
    run_tick(world, device, {}, event);
    const TickRecord& record = event.record;
    stretch.tick_us += static_cast<double>(event.cpu_ns) * 1e-3 / static_cast<double>(ticks);
    stretch.places.push_back({record.X_WH, record.X_WT});
    stretch.samples.push_back(event.sample);
    const Impact& impact = stretch.impacts.emplace_back(record.impact.value_or(ImpactTick()).hardest);
    EffectTick& seen = stretch.effects.emplace_back(seen_by_effects(event, scene, input));
    if (impact.speed > 0) seen.impacts = {&impact, 1};
    if (i % every == 0)
      stretch.times.push_back({{record.X_WT, record.V_WT}, event.sample, record.X_WH, record.coupling_F_T_W});
  }
  return stretch;
}

// Times each part of the tick over the stretch.
class StageClock {
public:
  StageClock(const SceneDesc& scene, const Stretch& stretch) : scene_(scene), stretch_(stretch) {
    us_["tick"] = stretch.tick_us;
  }
  void time_tool();
  void time_handle();
  void time_effects();
  std::map<std::string, double> take() {
    volatile double kept = unused_;
    static_cast<void>(kept);
    return std::move(us_);
  }

private:
  const SceneDesc& scene_;
  const Stretch& stretch_;
  std::map<std::string, double> us_;
  double unused_ = 0;       // summed up so that no call is optimised away
  double response_us_ = 0;  // of the whole motion, coupling and query included
};

void StageClock::time_tool() {
  const RigidBody body(scene_.tool.mass, scene_.tool.inertia_T);
  VirtualCoupling coupling(scene_.coupling, body);
  us_["coupling"] = mean_us(stretch_.times, [&](const TimePoint& m) {
    unused_ += coupling.pull(m.X_WH * scene_.tool.X_HT, {}, m.tool).force.x();
  });
  const std::unique_ptr<ToolMotion> motion = build_motion(scene_);
  response_us_ = mean_over(stretch_.places, [&](const Place& place) {
    std::uint32_t faults = 0;
    unused_ += motion->advance(place.X_WH * scene_.tool.X_HT, {}, faults).contact_F_T_W.force.x();
  });
  us_["response"] = response_us_;
  if (coupled(scene_.contact.response)) us_["response"] -= us_["coupling"];
  // A tool with mass queries once a tick. One without looks as often as it moves: its queries are its
  // response's.
  if (massless(scene_.contact.response)) return;
  ContactQuery query(scene_.tool_shell, scene_.scene_field);
  ContactSet set;
  us_["query"] = mean_over(stretch_.places, [&](const Place& place) { query.run(place.X_WT, set); });
  us_["integrator"] = mean_us(stretch_.times, [&](const TimePoint& m) {
    const Twist V = body.accelerate(m.tool, m.coupling_F_T_W, scene_.tick_s);
    unused_ += RigidBody::advance(m.tool.X_WT, V, scene_.tick_s).p.x();
  });
  us_["response"] -= us_["query"] + us_["integrator"];
}

void StageClock::time_handle() {
  VelocityEstimator velocity(scene_.velocity, scene_.tick_s);
  us_["estimator"] =
      mean_us(stretch_.times, [&](const TimePoint& m) { unused_ += velocity.update(m.X_WH).v.x(); });
  Allocator motors(scene_.device, scene_.allocation);
  us_["allocation"] = mean_us(stretch_.times, [&](const TimePoint& m) {
    motors.begin(m.sample.X_DH);
    unused_ += motors.wrench(m.coupling_F_T_W).force_share;
  });
  Guard guard(scene_.device, scene_.tick_s, transient_sources(scene_, scene_));
  us_["safety"] = mean_us(stretch_.times, [&](const TimePoint& m) {
    std::uint32_t faults = guard.watch(m.sample, {});
    unused_ += guard.limit(m.coupling_F_T_W, faults).force.x();
  });
  for (const TransientSource source : transient_sources(scene_, scene_))
    us_[figures_of(source).name] = mean_us(
        stretch_.times,
        [&](const TimePoint& m) {
          std::uint32_t faults = 0;
          unused_ +=
              guard.limit_transient(source, m.coupling_F_T_W * 0.01, {}, Vec6::Zero(), faults).force.x();
        });
  const auto beyond_us = [this](const PlainScene& without) {
    return std::max(follow_us(scene_, stretch_.samples) - follow_us(without, stretch_.samples), kMin_us);
  };
  if (scene_.holding_point) {
    PlainScene without = scene_;
    without.holding_point.reset();
    us_["holding point"] = beyond_us(without);
  }
  if (scene_.mapping.drift > 0) {
    PlainScene without = scene_;
    without.mapping.drift = 0;
    us_["workspace drift"] = beyond_us(without);
  }
}

void StageClock::time_effects() {
  for (const auto& effect : build_effects(scene_, scene_))
    us_[effect->part().name] =
        mean_over(stretch_.effects, [&](const EffectTick& tick) { unused_ += use(*effect, tick); });
  if (!detects_impacts(scene_)) return;
  ImpactDetector detector(scene_.impact, scene_.contact.region_radius, scene_.scene_field,
                          scene_.scene_objects);
  const std::unique_ptr<ToolMotion> motion = build_motion(scene_);
  const double both_us = mean_over(stretch_.places, [&](const Place& place) {
    std::uint32_t faults = 0;
    const Pose X_WG = place.X_WH * scene_.tool.X_HT;
    unused_ += motion->advance(X_WG, {}, faults).contact_F_T_W.force.x();
    detector.process({.X_WT = place.X_WT, .X_WG = X_WG, .V_WG = {}, .touching = motion->touching()});
  });
  us_["impacts"] = std::max(both_us - response_us_, kMin_us);
}

}  // namespace

Result<std::map<std::string, double>> measure_stages(const Prepared& prepared, const std::string& hand) {
  const SceneDesc& scene = prepared.haptic.scene;
  Result<World> world = World::build(scene);
  if (!world) return world.error();
  Result<std::unique_ptr<SimulatedDevice>> device = simulated_device(prepared, hand);
  if (!device) return device.error();
  const double seconds = std::min(kLongest, prepared.scenario.time_limit);
  const Stretch stretch = run_stretch(*world, **device, static_cast<std::size_t>(seconds / scene.tick_s));
  StageClock clock(scene, stretch);
  clock.time_tool();
  clock.time_handle();
  clock.time_effects();
  return clock.take();
}

}  // namespace fulcrum::app
