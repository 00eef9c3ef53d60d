#include <algorithm>
#include <filesystem>
#include <memory>
#include <system_error>

#include "drivers/registry.h"
#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/interrupt.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/commands/commands.h"
#include "engine/app/edit/edit_loop.h"
#include "engine/app/prepare/run_request.h"
#include "engine/app/settings/settings.h"
#include "engine/scenario/content.h"
#include "engine/ui/window.h"

namespace fulcrum::app {
namespace {

namespace fs = std::filesystem;

// What comes with the program is everybody's.
bool is_shipped(const fs::path& file) {
  std::error_code fault;
  const fs::path real = fs::weakly_canonical(file, fault);
  return std::ranges::any_of(scenario::content_roots(), [&](const fs::path& root) {
    std::error_code ignored;
    const fs::path folder = fs::weakly_canonical(root, ignored);
    return std::mismatch(folder.begin(), folder.end(), real.begin(), real.end()).first == folder.end();
  });
}

int edit_command(const RunOptions& given) {
  RunOptions options = given;
  const Result<fs::path> file = scenario::find_scenario(options.scenario);
  if (!file) {
    complain(file.error().sentence);
    return kError;
  }
  if (is_shipped(*file)) {
    complain("'" + options.scenario + "' comes with Fulcrum: copy it with `fulcrum new MINE --from " +
             options.scenario + "`, and edit that.");
    return kUsage;
  }
  const std::string no_window = ui::why_no_window();
  if (options.device.empty()) options.device = best_device(no_window).name;
  RequestedRun requested = request_run(options, no_window);
  if (!requested.scenario) return requested.code;
  catch_interrupts();
  const Result<std::unique_ptr<WindowStage>> stage =
      WindowStage::create("Fulcrum: " + requested.scenario->title, options, read_settings());
  if (!stage) {
    complain(stage.error().sentence);
    return kError;
  }
  return edit_in_window(**stage, *requested.scenario, *file, requested.calibration, options);
}

}  // namespace

void add_edit(Program& program) {
  const auto options = std::make_shared<RunOptions>();
  program.add(
      "edit", "Run a scenario of your own, and go on with each save of its files",
      [options](Arguments& arguments) {
        arguments.required({"scenario", "FILE", "Its file"}, options->scenario);
        arguments.text({"--device", "DEVICE", "One of `fulcrum devices` (default: the best that is there)"},
                       options->device);
        arguments.text({"--hand", "HAND", "With --device simulated: the hand that holds it"}, options->hand);
        arguments.flag("--mute", "Begin without sound; F4 brings it", options->muted);
        arguments.overrides(options->overrides);
        arguments.text({"--view", "NAME", "Where the window starts (default: the scenario's first)"},
                       options->view);
        arguments.size(options->size);
        arguments.text({"--gpu", "GPU", "Which GPU draws: its number or a part of its name"}, options->gpu);
        arguments.flag("--validate", "Draw under Vulkan's validation layers: slow", options->validate);
      },
      [options] { return edit_command(*options); });
}

}  // namespace fulcrum::app
