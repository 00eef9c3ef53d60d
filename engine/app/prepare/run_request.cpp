#include "engine/app/prepare/run_request.h"

#include <algorithm>
#include <cstdio>
#include <iterator>
#include <utility>

#include "drivers/registry.h"
#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/picture/impact_circle.h"
#include "engine/app/prepare/chosen_view.h"
#include "engine/app/prepare/device_choice.h"
#include "engine/app/prepare/prepare.h"

namespace fulcrum::app {

RequestedRun request_run(RunOptions& options, const std::string& no_window_reason) {
  Result<DeviceChoice> choice = choose_device(options.device);
  if (!choice) {
    complain(choice.error().sentence);
    return {std::nullopt, {}, kError};
  }
  options.device = choice->device;
  std::ranges::move(choice->overrides, std::back_inserter(options.overrides));
  std::optional<scenario::Scenario> scenario =
      load_named(options.scenario, options.overrides, choice->calibration);
  if (!scenario) return {std::nullopt, {}, kError};
  if (!choice->calibration.empty())
    std::fprintf(stderr, "Device: calibrated, as %s has it.\n", choice->calibration.c_str());
  if (scenario->left_handed) std::fprintf(stderr, "The scene is mirrored, for a tool in the left hand.\n");
  if (!scenario->why_right_handed.empty())
    std::fprintf(stderr, "The scene is not mirrored, as the calibration asks: %s.\n",
                 scenario->why_right_handed.c_str());
  if (const auto refused = refuse_view(*scenario, options.scenario, options.view)) {
    complain(refused->sentence);
    return {std::nullopt, {}, kUsage};
  }
  if (!options.participant.empty() && options.device.starts_with("replay:")) {
    complain("--participant: a replayed motion is nobody's trial. Leave one of the two out.");
    return {std::nullopt, {}, kUsage};
  }
  if (const auto refused = refuse_device(
          options.device,
          {no_window_reason, options.realtime || options.headset.asked, options.headset.asked})) {
    complain(refused->sentence);
    return {std::nullopt, {}, kError};
  }
  if (is_simulated(options.device)) {
    if (const auto refused = refuse_hand(*scenario, options.scenario, options.hand)) {
      complain(refused->sentence);
      return {std::nullopt, {}, kError};
    }
  }
  if (options.circle) {
    const DeviceDesc desc = options.device == "mouse" ? MouseDevice::mouse_desc() : scenario->device.desc;
    if (const auto refused = refuse_impact_circle(options.scenario, scenario->effects, desc)) {
      complain("--circle: " + refused->sentence);
      return {std::nullopt, {}, kUsage};
    }
  }
  return {std::move(scenario), std::move(choice->calibration), kCompleted};
}

}  // namespace fulcrum::app
