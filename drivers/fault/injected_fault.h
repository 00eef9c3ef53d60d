#pragma once
// Faults that a run is given on purpose, to see what a person would feel and what is left of the recording:
// `fulcrum run --fault NAME@T`. docs/faults.md says of each what follows.

#include <array>
#include <string>
#include <string_view>

#include "haptics/math/names_of.h"
#include "haptics/math/result.h"

namespace fulcrum {

enum class Injection {
  // Of the device: FaultyDevice.
  unplug,       // it is gone for good
  replug,       // it is gone, and back after half a second
  stall,        // it says nothing for half a second
  short_read,   // what it says is cut short, and so refused, for 10 ms
  garbage,      // it says nonsense that no checksum finds, for 5 samples
  nan,          // one sample is not a number
  frozen,       // it says the same pose for four seconds, as if it were new
  jump,         // its pose is 50 mm off from then on
  late_reply,   // what it says is 15 ms old, for half a second
  write_fail,   // it takes no command for half a second, and its driver notices
  sensor_drop,  // its strip is open for a second; where it has none, it no longer turns
  late,         // the haptic thread is 5 ms late every 20 ms, for half a second
  pause,        // the haptic thread stands still for 0.3 s
  // Of the program around it.
  disk_full,  // no file may grow any more
  kill,       // the process ends at once
  gpu_lost    // the graphics card is gone for good
};
template <>
inline constexpr std::array<std::string_view, 16> names_of<Injection>{
    "unplug",     "replug",     "stall",       "short-read", "garbage", "nan",       "frozen", "jump",
    "late-reply", "write-fail", "sensor-drop", "late",       "pause",   "disk-full", "kill",   "gpu-lost"};

struct InjectedFault {
  Injection kind;
  double at;  // s, of the device's samples: one a tick
};

// "NAME@T". Errors: there is no such fault, with those that there are; T is no time.
Result<InjectedFault> read_injected_fault(const std::string& text);

// It delays the haptic thread itself: ticks have to come by the clock.
bool needs_clock(Injection kind);

// It befalls the device, not the program.
bool is_of_device(Injection kind);

}  // namespace fulcrum
