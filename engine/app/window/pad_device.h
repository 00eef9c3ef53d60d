#pragma once
// The gamepad that is the device of a run, among those that the window sees.

#include <optional>
#include <span>
#include <string>
#include <vector>

#include "drivers/rate/pushed_axes.h"
#include "engine/ui/pads.h"

namespace fulcrum::app {

class PadDevice {
public:
  // What is pushed now; none: the pad is not there. The first that no driver of its own is for is the run's,
  // and plugged in again one of its make.
  std::optional<PushedAxes> read(std::span<const ui::PadState> pads);

private:
  std::string own_;  // its GUID
};

// Of the pads that Linux shows, for ui::learn_pads().
std::vector<std::string> gamepad_mappings();

// s, of a steady clock: when something was pressed.
double seconds_now();

}  // namespace fulcrum::app
