#pragma once
// What a gamepad's buttons ask for in a trial, whatever is the device: the same as keys do. Start again and
// the way back to the start page listen only where nothing is lost by a slip: in a stop, and after the end.

#include <cstdint>
#include <vector>

#include "engine/ui/overlay_state.h"

namespace fulcrum::app {

enum class PadPhase { running, stopped, ended };

enum class PadAction {
  stop,
  go_on,
  restart,
  start_page,
  keys,
  view_before,
  view_after,
  nearer,
  farther,
  look_back,
  look_on,
  event_before,
  event_after,
  card,
};

// Those that go on while they are held.
std::uint32_t repeating_pad_buttons();

// pressed: ui::PadButton's bits.
std::vector<PadAction> pad_actions(std::uint32_t pressed, PadPhase phase);

// What F1 says of them. has_views: there is more than one.
std::vector<ui::KeyLine> pad_lines(PadPhase phase, bool has_views, bool has_start_page);

// How sticks and triggers move the tool, where the pad is the device.
std::vector<std::string> pad_device_help();

}  // namespace fulcrum::app
