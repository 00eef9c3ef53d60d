#include "engine/app/run/run_session.h"

#include <algorithm>
#include <cstdio>
#include <utility>

#include "drivers/fault/faulty_device.h"
#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/picture/bridge.h"
#include "engine/app/prepare/scene_sound.h"
#include "engine/app/prepare/tape_header.h"

namespace fulcrum::app {
namespace {

Result<std::unique_ptr<Device>> any_device(auto made) {
  if (!made) return made.error();
  return std::unique_ptr<Device>(std::move(*made));
}

Result<OpenDevice> device_for(const Prepared& prepared, const SceneDesc& scene, const RunOptions& options) {
  const std::optional<ChannelUse> channels = channel_use(scene, scene);
  Result<OpenDevice> opened = open_device(
      options.device,
      {.desc = scene.device,
       .signal = channels ? std::optional(channels->signal) : std::nullopt,
       .X_DH = scene.tool.X_WT_start * scene.tool.X_HT.inverse(),
       .tick_s = scene.tick_s,
       .simulated = [&] { return any_device(simulated_device(prepared, options.hand)); },
       .replay = [&](const std::string& file) { return any_device(replay_device(prepared, file)); }});
  if (opened && opened->rate != nullptr) {
    const std::vector<scenario::View>& views = prepared.scenario.views;
    const render::Camera camera = views.empty() ? render::Camera() : views.front().camera;
    opened->rate->look(seen_frame(camera, scene.tool.X_WT_start.p, false));
  }
  if (!opened) return opened;
  for (const InjectedFault& fault : options.faults)
    if (is_of_device(fault.kind))
      opened->device = std::make_unique<FaultyDevice>(std::move(opened->device), fault, scene.tick_s);
  return opened;
}

record::HeardScene heard_scene(const audio::PlayedCounts& counts, const std::string& device) {
  record::HeardScene heard{device, counts.blows, counts.dropped, counts.late, counts.unplugged, std::nullopt};
  if (counts.measured > 0)
    heard.latency = {1e3 * counts.latency_sum / static_cast<double>(counts.measured),
                     1e3 * counts.latency_most};
  return heard;
}

std::unique_ptr<RunSession> refuse(const Error& error) {
  complain(error.sentence);
  return nullptr;
}

}  // namespace

std::unique_ptr<RunSession> RunSession::begin(const Prepared& prepared, const RunOptions& options,
                                              const Trainee& trainee) {
  const SceneDesc scene = scene_for_device(prepared, options.device);
  Result<OpenDevice> device = device_for(prepared, scene, options);
  if (!device) return refuse(device.error());
  Result<World> world = World::build(scene);
  if (!world) return refuse(world.error());
  std::optional<OpenResults> results;
  if (options.records) {
    const Result<record::TapeHeader> header =
        tape_header(prepared, device_in_results(prepared, options.device), options.hand);
    if (!header) return refuse(header.error());
    Result<OpenResults> opened = open_results(prepared.name, options, *header, *world, prepared.haptic.task);
    if (!opened) return refuse(opened.error());
    results = std::move(*opened);
  }
  const double limit =
      std::min(prepared.scenario.time_limit, options.seconds.value_or(prepared.scenario.time_limit));
  return std::unique_ptr<RunSession>(new RunSession(prepared, options, trainee, std::move(*device),
                                                    std::move(*world), std::move(results), limit));
}

RunSession::RunSession(const Prepared& prepared, const RunOptions& options, const Trainee& trainee,
                       OpenDevice device, World world, std::optional<OpenResults> results, double limit)
    : prepared_(prepared),
      options_(options),
      trainee_(trainee),
      device_(std::move(device)),
      world_(std::move(world)),
      folder_(results ? std::move(results->folder) : record::RunFolder()),
      faults_(options.faults, folder_.path),
      sink_(prepared, results ? std::optional(std::move(results->recorder)) : std::nullopt, limit, &faults_) {
  if (!options.faults.empty() || pushes_back(options.device)) sink_.watch_handle();
}

void RunSession::play_sound(bool says_why_not) {
  std::optional<audio::SceneSound> scene = scene_sound(prepared_, world_.desc());
  if (!scene) return;
  Result<audio::Output> output = audio::Output::open();
  if (output)
    player_ = std::make_unique<audio::Player>(std::move(*output), std::move(*scene));
  else if (says_why_not)
    complain("the run goes on in silence: " + output.error().sentence +
             ". Plug one in, or leave the sound out with --mute (docs/sound.md).");
}

int RunSession::finish(const render::RenderPlan* plan, bool person, const PictureFigures& figures) {
  RunSink::Outcome outcome = sink_.finish();
  outcome.summary.device = device_in_results(prepared_, options_.device);
  outcome.summary.left_handed = prepared_.scenario.left_handed;
  outcome.summary.hand = is_simulated(options_.device) ? options_.hand : "";
  outcome.summary.frames_per_s = figures.frames_per_s;
  outcome.summary.hand_to_pixel = figures.hand_to_pixel;
  outcome.summary.colocation = figures.colocation;
  if (device_.sound != nullptr) {
    const sound::FeedCounts counts = device_.sound->counts();
    std::fprintf(stderr, "%s\n", sound::sound_text(counts).c_str());
    if (counts.ticks > 0)
      outcome.summary.sound_latency = {1e3 * counts.latency_sum / static_cast<double>(counts.ticks),
                                       1e3 * counts.latency_most};
  }
  if (player_ != nullptr) {
    outcome.summary.heard = heard_scene(player_->counts(), player_->device());
    std::fprintf(stderr, "Heard: %s.\n", record::heard_text(*outcome.summary.heard).c_str());
  }
  Inventory list =
      inventory(world_, prepared_, plan, {options_.circle, options_.overlay != kNoOverlay, options_.device});
  add_scene_sound(prepared_, world_.desc(), player_ != nullptr || sink_.writes_sound(), list);
  add_headset(options_.headset, options_.device, list);
  bool written = write_results(folder_.path, outcome, list) && outcome.recorded;
  const FinishedTrial trial{prepared_,    sink_,  sink_.metrics(), outcome.summary,
                            folder_.path, began_, trainee_.expert, outcome.recorded};
  // The row first: a page that names somebody is one that a deletion finds.
  const bool kept = trainee_.participation != nullptr && keep_trial(trial, *trainee_.participation);
  if (trainee_.participation != nullptr && !kept) written = false;
  if (!write_trial_page(trial, kept ? options_.participant : std::string())) written = false;
  if (options_.json)
    std::printf("%s\n", record::summary_json(outcome.summary).c_str());
  else
    print_outcome(folder_.path, outcome, score_of(trial).total);
  if (!written) return kError;
  if (sink_.end() == RunSink::End::completed) return kCompleted;
  return sink_.stopped_by_fault() && !person ? kEndedByFault : kNotCompleted;
}

}  // namespace fulcrum::app
