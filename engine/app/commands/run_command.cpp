#include <algorithm>
#include <cstdio>
#include <memory>

#include "drivers/registry.h"
#include "engine/app/cli/beside.h"
#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/interrupt.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/commands/commands.h"
#include "engine/app/picture/picture.h"
#include "engine/app/prepare/colocation_choice.h"
#include "engine/app/prepare/run_request.h"
#include "engine/app/prepare/scene_sound.h"
#include "engine/app/run/expert.h"
#include "engine/app/run/headless_run.h"
#include "engine/app/run/run_session.h"
#include "engine/app/settings/settings.h"
#include "engine/app/window/train.h"
#include "engine/record/run_folder.h"
#include "engine/session/identity.h"
#include "engine/ui/window.h"
#include "haptics/math/number_text.h"

namespace fulcrum::app {
namespace {

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

// What --wav asks for; false: it cannot be had, and a sentence says why.
bool write_sound(const Prepared& prepared, const RunOptions& options, RunSession& attempt) {
  const std::optional<audio::SceneSound> scene = scene_sound(prepared, attempt.world().desc());
  if (!scene) {
    complain("--wav: the scenario '" + prepared.name +
             "' does not name 'sound', and nothing of it is heard.");
    return false;
  }
  const std::vector<scenario::View>& views = prepared.scenario.views;
  const auto view = std::ranges::find(views, options.view, &scenario::View::name);
  const render::Camera camera = view != views.end() ? view->camera
                                : views.empty()     ? render::Camera()
                                                    : views.front().camera;
  Result<std::unique_ptr<SoundFile>> file = SoundFile::create(
      attempt.folder() / record::kSoundName, *scene, listener_at(camera), options.muted ? 0 : options.volume);
  if (!file) {
    complain(file.error().sentence);
    return false;
  }
  attempt.sink().write_sound(std::move(*file));
  return true;
}

int run_headless(const Prepared& prepared, const RunOptions& options, Participation* participation) {
  // Before the trial: who ends it early has their figures all the same.
  std::optional<ExpertRun> expert;
  if (participation != nullptr) {
    expert = watch_expert_in_terminal(prepared);
    if (interrupted()) {
      complain("interrupted before the trial began: nothing was run.");
      return kNotCompleted;
    }
  }
  const Trainee trainee{participation, expert ? &expert->metrics : nullptr};
  const std::unique_ptr<RunSession> attempt = RunSession::begin(prepared, options, trainee);
  if (!attempt) return kError;
  if (options.wav && !write_sound(prepared, options, *attempt)) return kError;
  const bool acknowledges = !options.no_ack && !options.faults.empty();
  if (options.realtime)
    run_live(attempt->world(), attempt->device(), attempt->sink(), acknowledges);
  else
    run_offline(attempt->world(), attempt->device(), attempt->sink(), acknowledges);

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

// What is taken where nothing is asked for, and why: on stdout.
std::string device_in_hand() {
  const DeviceListing best = best_device(ui::why_no_window());
  if (best.name == "mouse")
    std::printf("Device: the mouse, since no other is there (fulcrum devices).\n");
  else
    std::printf("Device: %s, %s; another one by --device.\n", best.name.c_str(), best.what.c_str());
  return best.name;
}

int run_in_window(const scenario::Scenario& scenario, const RunOptions& options,
                  Participation* participation) {
  const Result<std::unique_ptr<WindowStage>> stage =
      WindowStage::create("Fulcrum: " + scenario.title, options, read_settings());
  if (!stage) {
    complain(stage.error().sentence);
    return kError;
  }
  return train(**stage, scenario, options, participation, false).code;
}

// Of a run that a headset shows: what else it cannot be; absent: nothing.
std::optional<std::string> refuse_headset(const RunOptions& options) {
  if (auto refused = refuse_without_headset(options.headset); refused || !options.headset.asked)
    return refused;
  if (options.headless) return "--xr shows the scene in a headset, and --headless nowhere: leave one out.";
  if (options.stereo.mode) return "--xr has a picture for each eye already: leave out --stereo.";
  if (const char* const length = given_length(options.stereo))
    return std::string("--xr has the headset's own eyes: leave out ") + length + ".";
  if (!options.gpu.empty())
    return "--xr draws with the card that the headset is plugged into: leave out --gpu.";
  if (options.headset.colocate && options.headset.scale != 1)
    return "--colocate shows the scene as large as it is felt: leave out --xr-scale.";
  if (options.headset.colocate && options.overlay == kNoOverlay)
    return "--colocate says on a panel what to touch: leave out --overlay none.";
  return std::nullopt;
}

// elsewhere: starts the program that shows scenes in a headset; in_headset: this is that program.
int run_command(const RunOptions& given, const std::function<int()>& elsewhere, RunInHeadset in_headset) {
  RunOptions options = given;
  if (options.gpu == "list") {
    std::printf("%s\n", describe_gpus().c_str());
    return kCompleted;
  }
  if (const auto refused = refuse_headset(options)) {
    complain(*refused);
    return kUsage;
  }
  if (options.headset.asked && in_headset == nullptr) return elsewhere();
  if (options.wav && !options.headless) {
    complain("--wav writes what a run without a window would sound like: add --headless.");
    return kUsage;
  }
  if (options.overlay == kNoOverlay && !options.headless && !options.headset.asked) {
    complain(
        "--overlay none leaves the panels out of the picture of a run without a window: add --headless, or "
        "--xr.");
    return kUsage;
  }
  if (const auto refused = refuse_stereo(options.stereo)) {
    complain(refused->sentence);
    return kUsage;
  }
  if (options.device.empty())
    options.device = options.headless ? "simulated" : options.headset.asked ? "controller" : device_in_hand();
  for (const InjectedFault& fault : options.faults) {
    if (needs_clock(fault.kind) && options.headless && !options.realtime) {
      complain("--fault " + std::string(name_of(fault.kind)) +
               " delays the haptic thread, which needs the clock: add --realtime.");
      return kUsage;
    }
  }
  if (!options.faults.empty()) complain("faults are injected: " + faults_text(options.faults) + ".");
  const std::string no_window =
      options.headset.asked ? kNoWindowInHeadset
      : options.headless
          ? "it needs a window: leave out --headless, or use --device simulated or replay:FILE."
          : ui::why_no_window();
  RequestedRun requested = request_run(options, no_window);
  if (!requested.scenario) return requested.code;
  if (options.headset.colocate && device_on_desk(options.device).empty()) {
    complain("--colocate is for a device with motors that stands on a desk, and " + options.device +
             " is none: leave it out, or name one with --device (fulcrum devices).");
    return kError;
  }
  std::optional<Participation> participation;
  if (!options.participant.empty()) {
    Result<Participation> begun = Participation::begin(options.participant);
    if (!begun) {
      complain(begun.error().sentence);
      return kError;
    }
    participation = std::move(*begun);
  }
  Participation* const trainee = participation ? &*participation : nullptr;
  if (options.headset.asked) {
    catch_interrupts();
    return in_headset(*requested.scenario, options, trainee);
  }
  if (!options.headless) {
    catch_interrupts();
    return run_in_window(*requested.scenario, options, trainee);
  }
  const std::optional<Prepared> prepared = prepare(options.scenario, std::move(*requested.scenario));
  if (!prepared) return kError;
  for (const std::string& note : prepared->haptic.repaired) complain(note);
  catch_interrupts();
  return run_headless(*prepared, options, trainee);
}

void add_run_command(Program& program, RunInHeadset in_headset) {
  const auto options = std::make_shared<RunOptions>();
  const auto seed = std::make_shared<std::optional<std::int64_t>>();
  program.add(
      "run", "Run a scenario, in a window or headless",
      [options, seed](Arguments& arguments) {
        arguments.required({"scenario", "NAME|FILE", "Its name (fulcrum list) or file"}, options->scenario);
        arguments.flag("--headless", "No window: as fast as it goes, one picture at the end",
                       options->headless);
        arguments.text(
            {"--hand", "HAND", "The simulated hand: expert, clumsy, still, or another of the scenario's"},
            options->hand);
        arguments.text({"--device", "DEVICE",
                        "One of `fulcrum devices`, such as simulated:MODEL, spacemouse+dualsense or "
                        "mouse+audio (default: the best that is there, with --xr the controllers)"},
                       options->device);
        arguments.texts({"--fault", "NAME@T",
                         "Inject a fault at T s, such as unplug@2 (docs/faults.md); may be given again"},
                        [options](const std::string& text) { return add_fault(text, options->faults); });
        arguments.flag("--no-ack",
                       "With --fault and --headless: a stop ends the run, and is not acknowledged",
                       options->no_ack);
        arguments.flag("--mute", "Begin without sound; F4 brings it", options->muted);
        arguments.flag("--wav", "With --headless: what would be heard, as sound.wav", options->wav);
        arguments.flag("--realtime", "Headless, but by the clock, in the haptic thread", options->realtime);
        arguments.positive({"--seconds", "S", "End after this much simulated time"}, options->seconds);
        arguments.count({"--seed", "N", "Seed of what is random, such as the hand's tremor"},
                        [seed](std::int64_t given) { *seed = given; });
        arguments.overrides(options->overrides);
        arguments.size(options->size);
        arguments.text(
            {"--view", "NAME",
             "The view of the picture, and where the window starts (default: the scenario's first)"},
            options->view);
        add_stereo(arguments, options->stereo);
        add_headset(arguments, options->headset);
        arguments.flag(
            "--circle",
            "After an impact, show where else on a tool it would have turned the hand about the same "
            "axis",
            options->circle);
        arguments.choice(
            "--overlay",
            "With --headless or --xr: what the picture has beside the scene, all or none (no panels, "
            "markers or ghosts)",
            options->overlay, {"all", kNoOverlay});
        arguments.text({"--gpu", "GPU", "Which GPU draws: its number, a part of its name, or 'list'"},
                       options->gpu);
        arguments.flag("--validate", "Draw under Vulkan's validation layers: slow; what they say is an error",
                       options->validate);
        arguments.text({"--participant", "PSEUDONYM", "Keep the result as theirs (fulcrum results)"},
                       [options](const std::string& name) {
                         const std::optional<Error> refused = session::refuse_pseudonym(name);
                         if (!refused) options->participant = name;
                         return refused ? refused->sentence : std::string();
                       });
        arguments.out(*options);
        arguments.json("Print the summary as JSON", options->json);
      },
      [options, seed, &program, in_headset] {
        // Now that all are read: --set has written its own list over what was there before.
        if (*seed) options->overrides.insert(options->overrides.begin(), "seed=" + std::to_string(**seed));
        const auto elsewhere = [&program] {
          return become({"fulcrum-xr", "a headset is shown its pictures"}, program.arguments());
        };
        return run_command(*options, elsewhere, in_headset);
      });
}

}  // namespace

void add_run(Program& program) {
  add_run_command(program, nullptr);
}

void add_run_in_headset(Program& program, RunInHeadset run) {
  add_run_command(program, run);
}

}  // namespace fulcrum::app
