#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "drivers/fault/injected_fault.h"
#include "engine/app/cli/headset_options.h"
#include "engine/app/cli/stereo_options.h"
#include "engine/render/plan.h"

namespace fulcrum::app {

// Of --overlay: the scene alone.
inline constexpr const char* kNoOverlay = "none";

// The command line of `fulcrum run`.
struct RunOptions {
  std::string scenario;
  bool headless = false;
  bool realtime = false;
  std::string hand = "expert";
  std::string device;                  // empty: the mouse in a window, simulated without
  std::optional<double> seconds;       // s, of simulated time
  std::vector<std::string> overrides;  // KEY=VALUE
  render::Extent size;                 // pixels
  std::string view;  // where the window starts and the picture is drawn from; empty: the first
  StereoOptions stereo;
  HeadsetOptions headset;
  double volume = 1;    // of what is heard in a window: 0 silent, 1 as it is
  bool muted = false;   // it begins silent; F4 changes that
  bool wav = false;     // headless: what would be heard, as sound.wav
  bool circle = false;  // of confusion, about the tool after an impact
  // Beside the scene in the picture: panels, markers and ghosts, or kNoOverlay.
  std::string overlay = "all";
  std::string gpu;            // empty: the best one
  bool validate = false;      // Vulkan's validation layers watch; what they say is an error
  std::filesystem::path out;  // empty: a new folder under the data directory
  std::string participant;    // a pseudonym; empty: nobody's results are kept
  bool force = false;         // replace results that are in `out`
  bool records = true;        // false: nothing of the run is written, and `out` is nothing
  bool json = false;
  std::vector<InjectedFault> faults;  // --fault
  bool no_ack = false;                // headless, with faults: a stop ends the run
};

}  // namespace fulcrum::app
