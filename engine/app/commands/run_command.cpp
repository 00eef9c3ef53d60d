#include <algorithm>
#include <cstdio>
#include <iterator>
#include <memory>

#include "drivers/fault/faulty_device.h"
#include "drivers/registry.h"
#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/interrupt.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/commands/commands.h"
#include "engine/app/picture/picture.h"
#include "engine/app/prepare/chosen_view.h"
#include "engine/app/prepare/device_choice.h"
#include "engine/app/prepare/tape_header.h"
#include "engine/app/run/headless_run.h"
#include "engine/app/run/results.h"
#include "engine/app/window/prepare_in_window.h"
#include "engine/app/window/training_window.h"
#include "engine/record/run_folder.h"
#include "engine/ui/window.h"
#include "haptics/math/number_text.h"

namespace fulcrum::app {
namespace {

// "WxH", each 16 to 16384 pixels.
std::string read_size(const std::string& text, render::Extent& size) {
  unsigned width = 0, height = 0;
  char rest = 0;
  if (std::sscanf(text.c_str(), "%ux%u%c", &width, &height, &rest) != 2 || width < 16 || height < 16 ||
      width > 16384 || height > 16384)
    return "'" + text + "' is no size: give WIDTHxHEIGHT in pixels, such as 1280x720, each from 16 to 16384";
  size = {width, height};
  return {};
}

// What is wrong with the text; empty: nothing, and it is one of the faults.
std::string add_fault(const std::string& text, std::vector<InjectedFault>& faults) {
  const Result<InjectedFault> fault = read_injected_fault(text);
  if (!fault) return fault.error().sentence;
  faults.push_back(*fault);
  return {};
}

// "nan at 1 s, stall at 3 s".
std::string faults_text(const std::vector<InjectedFault>& faults) {
  std::string text;
  for (const InjectedFault& fault : faults) {
    if (!text.empty()) text += ", ";
    text.append(name_of(fault.kind)).append(" at ").append(number_text(fault.at)).append(" s");
  }
  return text;
}

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

// Drawn from the view that was asked for, with the circle where it was.
Result<scenario::VisualAssembly> assemble_shown(const Prepared& prepared, const SceneDesc& scene,
                                                const RunOptions& options) {
  Result<scenario::VisualAssembly> visual = assemble_view(prepared, scene, options.view);
  if (visual && options.circle) add_impact_circle(visual->desc);
  return visual;
}

// One attempt, from opened files to closed ones.
class RunSession {
public:
  // What is wrong is on stderr.
  static std::unique_ptr<RunSession> begin(const Prepared& prepared, const RunOptions& options) {
    const SceneDesc scene = scene_for_device(prepared, options.device);
    Result<OpenDevice> device = device_for(prepared, scene, options);
    if (!device) return refuse(device.error());
    Result<World> world = World::build(scene);
    if (!world) return refuse(world.error());
    const Result<record::TapeHeader> header =
        tape_header(prepared, device_in_results(prepared, options.device), options.hand);
    if (!header) return refuse(header.error());
    Result<OpenResults> results = open_results(prepared.name, options, *header, *world, prepared.haptic.task);
    if (!results) return refuse(results.error());
    const double limit =
        std::min(prepared.scenario.time_limit, options.seconds.value_or(prepared.scenario.time_limit));
    return std::unique_ptr<RunSession>(
        new RunSession(prepared, options, std::move(*device), std::move(*world), std::move(*results), limit));
  }

  World& world() { return world_; }
  OpenDevice& device() { return device_; }
  RunSink& sink() { return sink_; }
  const ProgramFaults& faults() const { return faults_; }
  const std::filesystem::path& folder() const { return folder_; }

  // plan: what was drawn with, if anything was. person: one may acknowledge a stop, or leave; then no fault
  // ended the run.
  int finish(const render::RenderPlan* plan, bool person) {
    RunSink::Outcome outcome = sink_.finish();
    outcome.summary.device = device_in_results(prepared_, options_.device);
    outcome.summary.left_handed = prepared_.scenario.left_handed;
    outcome.summary.hand = is_simulated(options_.device) ? options_.hand : "";
    if (device_.sound != nullptr) {
      const sound::FeedCounts counts = device_.sound->counts();
      std::fprintf(stderr, "%s\n", sound::sound_text(counts).c_str());
      if (counts.ticks > 0)
        outcome.summary.sound_latency = {1e3 * counts.latency_sum / static_cast<double>(counts.ticks),
                                         1e3 * counts.latency_most};
    }
    const bool written =
        write_results(folder_, outcome,
                      inventory(world_, prepared_, plan, options_.circle, options_.device)) &&
        outcome.recorded;
    if (options_.json)
      std::printf("%s\n", record::summary_json(outcome.summary).c_str());
    else
      print_outcome(folder_, outcome);
    if (!written) return kError;
    if (sink_.end() == RunSink::End::completed) return kCompleted;
    return sink_.stopped_by_fault() && !person ? kEndedByFault : kNotCompleted;
  }

private:
  RunSession(const Prepared& prepared, const RunOptions& options, OpenDevice device, World world,
             OpenResults results, double limit)
      : prepared_(prepared),
        options_(options),
        device_(std::move(device)),
        world_(std::move(world)),
        folder_(std::move(results.folder)),
        faults_(options.faults, folder_),
        sink_(prepared, std::move(results.recorder), limit, &faults_) {
    if (!options.faults.empty() || pushes_back(options.device)) sink_.watch_handle();
  }

  static std::unique_ptr<RunSession> refuse(const Error& error) {
    complain(error.sentence);
    return nullptr;
  }

  const Prepared& prepared_;
  const RunOptions& options_;
  OpenDevice device_;
  World world_;
  std::filesystem::path folder_;
  ProgramFaults faults_;
  RunSink sink_;
};

int run_headless(const Prepared& prepared, const RunOptions& options) {
  const std::unique_ptr<RunSession> attempt = RunSession::begin(prepared, options);
  if (!attempt) return kError;
  const bool acknowledges = !options.no_ack && !options.faults.empty();
  if (options.realtime)
    run_live(attempt->world(), *attempt->device().device, attempt->sink(), acknowledges);
  else
    run_offline(attempt->world(), *attempt->device().device, attempt->sink(), acknowledges);

  // The picture is the last moment. Without Vulkan the run counts all the same.
  render::RenderPlan plan;
  bool drawn = false;
  const Result<scenario::VisualAssembly> visual = assemble_shown(prepared, attempt->world().desc(), options);
  if (visual) {
    const RunSink& sink = attempt->sink();
    const FrameInput input{sink.last(), sink.afterglow(), sink.task(), visual->desc.camera,
                           attempt->faults().gpu_lost()};
    const auto picture = draw_picture(prepared, attempt->world().desc(), *visual, input, options,
                                      attempt->folder() / record::kPictureName, &plan);
    drawn = static_cast<bool>(picture);
    if (!drawn) complain("there is no picture: " + picture.error().sentence);
  } else {
    complain("there is no picture: " + visual.error().sentence);
  }
  const int code = attempt->finish(drawn ? &plan : nullptr, false);
  return options.validate && !drawn ? static_cast<int>(kError) : code;
}

int run_in_window(const scenario::Scenario& scenario, const RunOptions& options) {
  const Result<std::unique_ptr<WindowStage>> stage =
      WindowStage::create("Fulcrum: " + scenario.title, options);
  if (!stage) {
    complain(stage.error().sentence);
    return kError;
  }
  const PreparedInWindow ready = prepare_in_window(**stage, options.scenario, scenario);
  if (ready.closed) {
    complain("the window was closed before the scenario was ready: nothing was run.");
    return kNotCompleted;
  }
  if (!ready.prepared) return kError;
  const Prepared& prepared = *ready.prepared;
  for (const std::string& note : prepared.haptic.repaired) complain(note);
  const Result<scenario::VisualAssembly> visual =
      assemble_shown(prepared, scene_for_device(prepared, options.device), options);
  if (!visual) {
    complain(visual.error().sentence);
    return kError;
  }
  const Result<std::unique_ptr<TrainingWindow>> window =
      TrainingWindow::create(**stage, prepared, *visual, options);
  if (!window) {
    complain(window.error().sentence);
    return kError;
  }
  RunOptions attempt_options = options;
  for (int number = 1;; ++number) {
    if (number > 1 && !options.out.empty())
      attempt_options.out = options.out / ("attempt-" + std::to_string(number));
    const std::unique_ptr<RunSession> attempt = RunSession::begin(prepared, attempt_options);
    if (!attempt) return kError;
    const TrainingWindow::Leave leave =
        (*window)->run(attempt->world(), attempt->device(), attempt->sink(), attempt->faults());
    const auto picture = (*window)->save_picture(attempt->sink(), attempt->folder() / record::kPictureName);
    if (!picture) complain("there is no picture: " + picture.error().sentence);
    const int code = attempt->finish(&(*window)->plan(), true);
    if (leave == TrainingWindow::Leave::restart) continue;
    for (const std::string& message : (*stage)->validation_messages()) complain(message);
    return (*stage)->validation_messages().empty() ? code : static_cast<int>(kError);
  }
}

// What is taken where nothing is asked for, and why: on stdout.
std::string device_in_hand() {
  const DeviceListing best = best_device(ui::why_no_window());
  if (best.name == "mouse")
    std::printf("Device: the mouse, since no other is there (fulcrum devices).\n");
  else
    std::printf("Device: %s, %s; another one by --device.\n", best.name.c_str(), best.what.c_str());
  return best.name;
}

int run_command(const RunOptions& given) {
  RunOptions options = given;
  if (options.gpu == "list") {
    std::printf("%s\n", describe_gpus().c_str());
    return kCompleted;
  }
  if (options.device.empty()) options.device = options.headless ? "simulated" : device_in_hand();
  for (const InjectedFault& fault : options.faults) {
    if (needs_clock(fault.kind) && options.headless && !options.realtime) {
      complain("--fault " + std::string(name_of(fault.kind)) +
               " delays the haptic thread, which needs the clock: add --realtime.");
      return kUsage;
    }
  }
  if (!options.faults.empty()) complain("faults are injected: " + faults_text(options.faults) + ".");
  Result<DeviceChoice> choice = choose_device(options.device);
  if (!choice) {
    complain(choice.error().sentence);
    return kError;
  }
  options.device = choice->device;
  std::ranges::move(choice->overrides, std::back_inserter(options.overrides));
  std::optional<scenario::Scenario> scenario =
      load_named(options.scenario, options.overrides, choice->calibration);
  if (!scenario) return kError;
  if (!choice->calibration.empty())
    std::fprintf(stderr, "Device: calibrated, as %s has it.\n", choice->calibration.c_str());
  if (scenario->left_handed) std::fprintf(stderr, "The scene is mirrored, for a tool in the left hand.\n");
  if (!scenario->why_right_handed.empty())
    std::fprintf(stderr, "The scene is not mirrored, as the calibration asks: %s.\n",
                 scenario->why_right_handed.c_str());
  if (const auto refused = refuse_view(*scenario, options.scenario, options.view)) {
    complain(refused->sentence);
    return kUsage;
  }
  const std::string no_window =
      options.headless ? "it needs a window: leave out --headless, or use --device simulated or replay:FILE."
                       : ui::why_no_window();
  if (const auto refused = refuse_device(options.device, no_window, options.realtime)) {
    complain(refused->sentence);
    return kError;
  }
  if (is_simulated(options.device)) {
    if (const auto refused = refuse_hand(*scenario, options.scenario, options.hand)) {
      complain(refused->sentence);
      return kError;
    }
  }
  if (options.circle) {
    const DeviceDesc desc = options.device == "mouse" ? MouseDevice::mouse_desc() : scenario->device.desc;
    if (const auto refused = refuse_impact_circle(options.scenario, scenario->effects, desc)) {
      complain("--circle: " + refused->sentence);
      return kUsage;
    }
  }
  if (!options.headless) {
    catch_interrupts();
    return run_in_window(*scenario, options);
  }
  const std::optional<Prepared> prepared = prepare(options.scenario, std::move(*scenario));
  if (!prepared) return kError;
  for (const std::string& note : prepared->haptic.repaired) complain(note);
  catch_interrupts();
  return run_headless(*prepared, options);
}

}  // namespace

void add_run(Program& program) {
  const auto options = std::make_shared<RunOptions>();
  program.add(
      "run", "Run a scenario, in a window or headless",
      [options](Arguments& arguments) {
        arguments.required({"scenario", "NAME|FILE", "Its name (fulcrum list) or file"}, options->scenario);
        arguments.flag("--headless", "No window: as fast as it goes, one picture at the end",
                       options->headless);
        arguments.text(
            {"--hand", "HAND", "The simulated hand: expert, clumsy, still, or another of the scenario's"},
            options->hand);
        arguments.text(
            {"--device", "DEVICE",
             "One of `fulcrum devices`, such as simulated:MODEL, spacemouse+dualsense or mouse+audio; none: "
             "the best that is "
             "there"},
            options->device);
        arguments.texts({"--fault", "NAME@T",
                         "Inject a fault at T s, such as unplug@2 (docs/faults.md); may be given again"},
                        [options](const std::string& text) { return add_fault(text, options->faults); });
        arguments.flag("--no-ack",
                       "With --fault and --headless: a stop ends the run, and is not acknowledged",
                       options->no_ack);
        arguments.flag("--realtime", "Headless, but by the clock, in the haptic thread", options->realtime);
        arguments.positive({"--seconds", "S", "End after this much simulated time"}, options->seconds);
        arguments.integer(
            {"--seed", "N", "Seed of what is random, such as the hand's tremor"},
            [options](std::int64_t seed) { options->overrides.push_back("seed=" + std::to_string(seed)); });
        arguments.overrides(options->overrides);
        arguments.text({"--size", "WxH", "Of the picture or the window, in pixels (default 1280x720)"},
                       [options](const std::string& text) { return read_size(text, options->size); });
        arguments.text(
            {"--view", "NAME",
             "The view of the picture, and where the window starts (default: the scenario's first)"},
            options->view);
        arguments.flag(
            "--circle",
            "After an impact, show where else on a tool it would have turned the hand about the same "
            "axis",
            options->circle);
        arguments.text({"--gpu", "GPU", "Which GPU draws: its number, a part of its name, or 'list'"},
                       options->gpu);
        arguments.flag("--validate", "Draw under Vulkan's validation layers: slow; what they say is an error",
                       options->validate);
        arguments.out(*options);
        arguments.json("Print the summary as JSON", options->json);
      },
      [options] { return run_command(*options); });
}

}  // namespace fulcrum::app
