#include "engine/app/cli/headset_options.h"

#include "engine/app/cli/program.h"

namespace fulcrum::app {

void add_headset(Arguments& arguments, HeadsetOptions& options) {
  arguments.flag("--xr", "Show it in a headset, by OpenXR (docs/headset.md)", options.asked);
  arguments.choice("--xr-space",
                   "With --xr: the scene is before who begins (local), or in the middle of the floor (stage)",
                   options.space, {kLocalSpace, kStageSpace});
  arguments.number({"--xr-scale", "N", "With --xr: how many times life-size the scene is (default 1)"},
                   options.scale, 0.1, 100);
}

}  // namespace fulcrum::app
