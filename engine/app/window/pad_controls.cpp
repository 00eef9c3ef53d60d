#include "engine/app/window/pad_controls.h"

#include <utility>

#include "engine/ui/pads.h"

namespace fulcrum::app {
namespace {

struct Control {
  std::uint32_t button;
  PadAction action;
};

constexpr Control kAlways[] = {
    {ui::kPadX, PadAction::keys},
    {ui::kPadUp, PadAction::nearer},
    {ui::kPadDown, PadAction::farther},
};
constexpr Control kInTrial[] = {
    {ui::kPadB, PadAction::stop},           {ui::kPadStart, PadAction::stop},
    {ui::kPadA, PadAction::go_on},          {ui::kPadLeft, PadAction::view_before},
    {ui::kPadRight, PadAction::view_after},
};
constexpr Control kAtRest[] = {
    {ui::kPadY, PadAction::restart},
    {ui::kPadBack, PadAction::start_page},
};
constexpr Control kAfter[] = {
    {ui::kPadA, PadAction::card},
    {ui::kPadLeft, PadAction::look_back},
    {ui::kPadRight, PadAction::look_on},
    {ui::kPadLeftBumper, PadAction::event_before},
    {ui::kPadRightBumper, PadAction::event_after},
};

}  // namespace

std::uint32_t repeating_pad_buttons() {
  return ui::kPadUp | ui::kPadDown | ui::kPadLeft | ui::kPadRight;
}

std::vector<PadAction> pad_actions(std::uint32_t pressed, PadPhase phase) {
  std::vector<PadAction> actions;
  const auto take = [&](const auto& controls) {
    for (const Control& control : controls)
      if ((pressed & control.button) != 0) actions.push_back(control.action);
  };
  take(kAlways);
  if (phase != PadPhase::running) take(kAtRest);
  if (phase == PadPhase::ended)
    take(kAfter);
  else
    take(kInTrial);
  return actions;
}

std::vector<ui::KeyLine> pad_lines(PadPhase phase, bool has_views, bool has_start_page) {
  std::vector<ui::KeyLine> lines;
  if (phase == PadPhase::ended) {
    lines.push_back({"Pad: cross", "left and right look back at the trial; bumpers, by events"});
    lines.push_back({"A", "show or hide what came of it"});
  } else {
    lines.push_back({"Pad: B, Start", "stop force and time"});
    lines.push_back({"A", "go on; the force returns"});
    lines.push_back(
        {"Cross", has_views ? "left and right go to other views; up and down zoom" : "up and down zoom"});
  }
  const char* const when = phase == PadPhase::running ? "once stopped: " : "";
  lines.push_back({has_start_page ? "Y, Back" : "Y",
                   std::string(when) + (has_start_page ? "start again, to the start page" : "start again")});
  lines.push_back({"X", "show or hide this list"});
  return lines;
}

std::vector<std::string> pad_device_help() {
  return {"Left stick: tool left, right, up, down", "Triggers: right away, left nearer",
          "Right stick: tool tilts and turns", "Bumpers: tool rolls left and right"};
}

}  // namespace fulcrum::app
