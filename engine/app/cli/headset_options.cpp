#include "engine/app/cli/headset_options.h"

#include "engine/app/cli/program.h"

namespace fulcrum::app {

void add_headset_space(Arguments& arguments, HeadsetOptions& options) {
  arguments.choice("--xr-space",
                   "With --xr: the scene is before who begins (local), or in the middle of the floor (stage)",
                   options.space, {kLocalSpace, kStageSpace});
}

void add_headset(Arguments& arguments, HeadsetOptions& options) {
  arguments.flag("--xr", "Show it in a headset, by OpenXR (docs/headset.md)", options.asked);
  add_headset_space(arguments, options);
  arguments.number({"--xr-scale", "N", "With --xr: how many times life-size the scene is (default 1)"},
                   options.scale, 0.1, 100);
  arguments.flag(
      "--colocate",
      "With --xr: touch points with the device and a controller first, so that it is seen where it "
      "is felt",
      options.colocate);
  arguments.number(
      {"--colocate-limit", "MM", "With --colocate: the largest residual that is kept (default 10)"},
      options.colocate_limit_mm, 0.1, 1000);
}

std::optional<std::string> refuse_without_headset(const HeadsetOptions& options) {
  const HeadsetOptions nothing;
  if (options.asked) {
    if (options.colocate || options.colocate_limit_mm == nothing.colocate_limit_mm) return std::nullopt;
    return "--colocate-limit is of a device that is laid onto a headset's space: add --colocate.";
  }
  if (options.colocate) return "--colocate lays the device onto a headset's space: add --xr.";
  if (options.colocate_limit_mm != nothing.colocate_limit_mm)
    return "--colocate-limit is of a device that is laid onto a headset's space: add --xr and --colocate.";
  if (options.space != nothing.space) return "--xr-space is where a headset shows the scene: add --xr.";
  if (options.scale != nothing.scale) return "--xr-scale is how large a headset shows the scene: add --xr.";
  return std::nullopt;
}

}  // namespace fulcrum::app
