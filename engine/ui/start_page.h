#pragma once
// The page that a person starts from: scenarios at the left, what is chosen of one at the right.

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "engine/render/plan.h"
#include "engine/ui/device_panel.h"
#include "engine/ui/look.h"

namespace fulcrum::ui {

struct StartPage {
  struct Scenario {
    std::string title;
    std::string best;    // "best 87"; empty: nothing is known
    bool usable = true;  // otherwise `facts` says what is wrong
  };
  struct Setting {
    std::string name;      // "Device"
    std::string value;     // "the mouse"
    bool written = false;  // it is being written: a caret stands after it
  };
  enum class Part { scenario, setting, start, settings, end };  // the last three are buttons, from the left

  std::vector<Scenario> scenarios;
  std::size_t chosen = 0;  // of them
  std::string about;       // its sentence
  std::string facts;       // "easy, 6 checkpoints, 90 s"
  std::vector<Setting> settings;
  Part focus = Part::scenario;
  std::size_t index = 0;                // of the scenario or the setting in focus
  std::string note;                     // a sentence about what went wrong; empty: none
  std::string help;                     // what keys do
  std::optional<DevicePanel> tested{};  // in place of all of it: a device that is being tried
};

// What lies under the pointer. side: of a setting, -1 its left arrow, 1 its right one, else 0.
struct StartHit {
  StartPage::Part part = StartPage::Part::scenario;
  std::size_t index = 0;
  int side = 0;
};

// x, y: fractions of the picture's height, from its top left.
std::optional<StartHit> start_hit(const StartPage& page, render::Extent picture, const Look& look, double x,
                                  double y);

}  // namespace fulcrum::ui
