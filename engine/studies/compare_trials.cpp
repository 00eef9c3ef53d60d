#include "engine/studies/compare_trials.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "engine/record/run_totals.h"
#include "engine/scenario/task_judge.h"
#include "haptics/bake/parallel.h"
#include "haptics/loop/run_tick.h"
#include "haptics/math/number_text.h"

namespace fulcrum::app {
namespace {

constexpr double kMomentEvery = 20e-3;  // s, of a course

// Looks on while the first trial of a variant runs.
class CourseWatch {
public:
  CourseWatch(double tick_s, std::vector<analysis::compare::TimePoint>& course)
      : every_(std::max<std::int64_t>(1, std::llround(kMomentEvery / tick_s))),
        tick_s_(tick_s),
        course_(course) {}

  void see(const TickRecord& record) {
    bad_ |= record.torque_substitution->bad;
    if (record.tick % every_ != 0) return;
    course_.push_back({.time = static_cast<double>(record.tick) * tick_s_,
                       .torque = record.coupling_F_T_W.torque.norm(),
                       .bad = std::exchange(bad_, false),
                       .vibration = record.torque_substitution->vibration,
                       .ghost = record.torque_substitution->ghost});
  }

private:
  std::int64_t every_;
  double tick_s_;
  std::vector<analysis::compare::TimePoint>& course_;
  bool bad_ = false;
};

class Trials {
public:
  Trials(const Prepared& prepared, const CompareOptions& options) : prepared_(prepared), options_(options) {}

  Result<std::unique_ptr<Device>> device(std::uint64_t trial) const {
    if (!options_.tape.empty()) {
      auto replay = replay_device(prepared_, options_.tape);
      if (!replay) return replay.error();
      return std::unique_ptr<Device>(std::move(*replay));
    }
    auto simulated = simulated_device(prepared_, options_.hand, trial);
    if (!simulated) return simulated.error();
    return std::unique_ptr<Device>(std::move(*simulated));
  }

  Result<World> world(TorqueVariant variant) const {
    SceneDesc scene = prepared_.haptic.scene;
    scene.torque_substitution->variant = variant;
    return World::build(std::move(scene));
  }

  analysis::compare::Trial run(World& world, Device& device, std::uint64_t number, CourseWatch* watch) const {
    const double tick_s = prepared_.haptic.scene.tick_s;
    const auto* replay = dynamic_cast<const ReplayDevice*>(&device);
    const std::int64_t limit = std::llround(prepared_.scenario.time_limit / tick_s);
    scenario::TaskJudge judge(prepared_.haptic.task, tick_s);
    record::RunTotals totals(tick_s);
    bool stopped = false;
    while (!judge.state().completed && !stopped && totals.ticks() < limit &&
           !(replay != nullptr && replay->finished())) {
      TickEvent event;
      run_tick(world, device, {}, event);
      judge.judge(event.record);
      totals.add(event.record);
      stopped = event.record.stopped;
      if (watch != nullptr) watch->see(event.record);
    }
    return {.seed = prepared_.scenario.seed + static_cast<std::int64_t>(number),
            .torque_error_Nms = totals.torque_error_Nms(),
            .force_error_Ns = totals.force_error_Ns(),
            .completion_time_s = judge.completion_time(),
            .fault = stopped ? totals.faults().front().name : std::string()};
  }

private:
  const Prepared& prepared_;
  const CompareOptions& options_;
};

analysis::compare::Comparison described(const Prepared& prepared, const CompareOptions& options,
                                        const World& world) {
  analysis::compare::Comparison comparison;
  comparison.scenario = prepared.name;
  comparison.title = prepared.scenario.title;
  comparison.device = device_on_screen(prepared, prepared.haptic.scene);
  comparison.time_limit_s = prepared.scenario.time_limit;
  comparison.bad_above_Nm =
      torque_thresholds(*prepared.haptic.scene.torque_substitution, prepared.haptic.scene.coupling.max_torque)
          .bad;
  comparison.tape = options.tape;
  if (options.tape.empty()) comparison.hand = options.hand;
  for (const scenario::HandScript& hand : prepared.haptic.hands)
    if (options.tape.empty() && hand.name == options.hand) comparison.yields = hand.desc.yields;
  const CouplingDesc& coupling = prepared.haptic.scene.coupling;
  comparison.built = {{"coupling", number_text(coupling.stiffness) + " N/m up to " +
                                       number_text(coupling.max_force) + " N, " +
                                       number_text(coupling.angular_stiffness) + " N m/rad up to " +
                                       number_text(coupling.max_torque) + " N m"}};
  for (const BuiltPart& part : world.parts())
    if (part.name == "torque substitution") comparison.built.push_back({part.name, part.what});
  return comparison;
}

}  // namespace

std::optional<Error> nothing_to_compare(const Prepared& prepared, const CompareOptions& options) {
  const SceneDesc& scene = prepared.haptic.scene;
  if (!scene.torque_substitution)
    return Error{"The scenario '" + prepared.name +
                 "' does not name torque_substitution, so it has no variants: add 'torque_substitution: {}' "
                 "to its file."};
  if (scene.device.renders_torque)
    return Error{"The device '" + scene.device.name +
                 "' renders torque, so there is nothing to substitute and nothing to compare: choose a "
                 "device that does not (device.model)."};
  const Trials trials(prepared, options);
  if (const auto device = trials.device(0); !device) return device.error();
  if (const auto world = trials.world(options.variants.front()); !world) return world.error();
  return std::nullopt;
}

analysis::compare::Comparison run_trials(const Prepared& prepared, const CompareOptions& options,
                                         const std::function<void(double)>& progress) {
  const Trials trials(prepared, options);
  const std::size_t count = options.tape.empty() ? options.trials : 1;
  analysis::compare::Comparison comparison =
      described(prepared, options, *trials.world(options.variants.front()));
  for (const TorqueVariant variant : options.variants)
    comparison.variants.push_back(
        {std::string(name_of(variant)), std::vector<analysis::compare::Trial>(count), {}});
  for_each_piece(
      comparison.variants.size() * count, 0,
      [&](std::size_t piece) {
        const std::size_t variant = piece / count, number = piece % count;
        analysis::compare::VariantRuns& runs = comparison.variants[variant];
        Result<World> own_world = trials.world(options.variants[variant]);
        const Result<std::unique_ptr<Device>> own_device = trials.device(number);
        CourseWatch watch(prepared.haptic.scene.tick_s, runs.course);
        runs.trials[number] = trials.run(*own_world, **own_device, number, number == 0 ? &watch : nullptr);
      },
      progress);
  return comparison;
}

}  // namespace fulcrum::app
