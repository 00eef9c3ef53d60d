#include "tests/bench/parts/parts_cost.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "haptics/bake/field_bake.h"
#include "haptics/bake/pointshell_bake.h"
#include "haptics/bake/solid.h"
#include "haptics/math/rotation.h"
#include "haptics/math/split_mix.h"
#include "haptics/world/world.h"
#include "tests/bench/cpu_time.h"
#include "tests/parts/exact_depth.h"

namespace fulcrum::bench {
namespace {

constexpr double kRun_s = 2;
constexpr double kDeviation = 50e-6;       // m, of the shell
constexpr double kJudgeSpacing = 0.25e-3;  // m
constexpr int kJudged = 60;                // ticks of a run

// Where the hand wants the tool at s.
Pose wanted(const parts::Fit& fit, PartHand hand, double s, SplitMix& random) {
  const double ease = std::min(1.0, s / 0.2);
  const Vec3 axis = fit.way_W, across = fit.across_W;
  const auto about = [&](const Vec3& turn_axis, double angle, const Vec3& shift) {
    return Pose{quaternion_exp(angle * turn_axis) * fit.X_WT.q, fit.X_WT.p + shift};
  };
  const auto along_the_way = [&](double part) {  // -1 to 1
    if (fit.pitch > 0) return about(axis, 2 * part, axis * (fit.pitch * 2 * part / (2 * std::numbers::pi)));
    return about(axis, 0, axis * (2e-3 * part));
  };
  switch (hand) {
    case PartHand::expert:
      return along_the_way(std::sin(2 * std::numbers::pi * s));
    case PartHand::sideways: {
      Pose X = along_the_way(0.5 * std::sin(2 * std::numbers::pi * s));
      X.p += 3e-3 * ease * across;
      return X;
    }
    case PartHand::lean:
      return about(axis.cross(across), 0.2 * ease * std::sin(6 * s), axis * (1e-3 * std::sin(9 * s)));
    case PartHand::strike: {
      // To and fro at 1 m/s, 10 mm to either side.
      const double phase = std::fmod(s, 0.04) / 0.04, way = phase < 0.5 ? 4 * phase - 1 : 3 - 4 * phase;
      return about(axis, 0, 10e-3 * way * across);
    }
    case PartHand::jitter: {
      const auto any = [&] { return 2 * random.uniform() - 1; };
      const Vec3 shift(any(), any(), any()), turn(any(), any(), any());
      return {quaternion_exp(0.05 * turn) * fit.X_WT.q, fit.X_WT.p + 2e-3 * shift};
    }
    case PartHand::spin:
      return about(axis, 2 * std::numbers::pi * 2 * s, 1e-3 * ease * across);
    case PartHand::yank:
      return about(axis, 0, axis * (50e-3 * std::sin(2 * std::numbers::pi * 5 * s) * ease));
  }
  return fit.X_WT;
}

// At a scenario's default settings, in a hand that is the device.
Result<SceneDesc> scene_of(const parts::Fit& fit, Measured measured, PartCost& cost) {
  const double before = cpu_s(CLOCK_PROCESS_CPUTIME_ID);
  const Result<Solid> tool = build_solid(fit.tool_T), scene = build_solid(fit.scene_W);
  if (!tool) return tool.error();
  if (!scene) return scene.error();
  SceneDesc desc;
  const auto shell = bake_pointshell(*tool, {.deviation = kDeviation});
  if (!shell) return shell.error();
  auto field = bake_field(*scene, {});
  if (!field) return field.error();
  cost.bake_cpu_s = cpu_s(CLOCK_PROCESS_CPUTIME_ID) - before;
  cost.MB = 1e-6 * static_cast<double>(field->bytes());
  desc.tool_shell = std::make_shared<const Pointshell>(*shell);
  desc.scene_field = std::make_shared<const DistanceField>(std::move(*field));
  if (measured == Measured::triangles) {
    desc.tool_features = std::make_shared<const FeatureMesh>(tool->mesh, tool->neighbours);
    desc.scene_features = std::make_shared<const FeatureMesh>(scene->mesh, scene->neighbours);
    cost.MB = 1e-6 * static_cast<double>(desc.tool_features->bytes() + desc.scene_features->bytes());
  }
  desc.tool.X_WT_start = fit.X_WT;
  // A tool with weight starts below its place, by what the coupling's spring yields to it.
  desc.tool.weight = false;
  desc.device.kinematics = Kinematics::none;
  desc.device.renders_force = false;
  desc.device.senses_rotation = true;
  return desc;
}

}  // namespace

const char* name_of(PartHand hand) {
  constexpr const char* names[] = {"expert", "sideways", "lean", "strike", "jitter", "spin", "yank"};
  return names[static_cast<std::size_t>(hand)];
}

PartCost cost_of(const parts::Fit& fit, Measured measured, bool smoke) {
  PartCost cost;
  const Result<SceneDesc> desc = scene_of(fit, measured, cost);
  if (!desc) return {.refused = desc.error().sentence};
  const parts::ExactDepth judge(fit.tool_T, fit.scene_W, kJudgeSpacing);
  for (const PartHand hand : kPartHands) {
    Result<World> world = World::build(*desc);
    if (!world) return {.refused = world.error().sentence};
    PartCost::Run run;
    SplitMix random(11);
    std::vector<double> us;
    const int ticks = smoke ? 20 : static_cast<int>(kRun_s / desc->tick_s);
    double least_looked_at = 0;
    for (int tick = 0; tick < ticks; ++tick) {
      const Pose X_WT = wanted(fit, hand, tick * desc->tick_s, random);
      DeviceSample sample;
      sample.X_DH = desc->mapping.handle_in_device(X_WT * desc->tool.X_HT.inverse());
      sample.connected = true;
      StepResult result;
      us.push_back(cpu_us([&] { result = step(*world, sample, {}); }));
      run.reported = std::max(run.reported, result.record.depth_max);
      // Now and then, and whenever it reports more than ever.
      const bool look =
          tick % std::max(1, ticks / kJudged) == 0 || result.record.depth_max > 1.05 * least_looked_at;
      if (!look) continue;
      least_looked_at = std::max(least_looked_at, result.record.depth_max);
      run.judged = std::max(run.judged, judge.at(result.record.X_WT));
    }
    run.median_us = quantile(us, 0.5);
    run.p99_us = quantile(us, 0.99);
    cost.runs.push_back(run);
  }
  return cost;
}

}  // namespace fulcrum::bench
