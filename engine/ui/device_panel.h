#pragma once
// What a device senses now, in place of the start page.

#include <string>
#include <vector>

#include "engine/render/plan.h"
#include "engine/ui/look.h"

namespace fulcrum::ui {

struct DevicePanel {
  struct Axis {
    std::string name;    // "right"
    double part = 0;     // -1 to 1, of what it reaches
    std::string value;   // "12 mm"
    bool moved = false;  // it has, since the test began
  };
  std::string title;  // "What gamepad senses"
  std::vector<Axis> axes;
  std::string buttons;             // "Buttons: A, left bumper"; empty: the device has told of none
  std::string trouble;             // what is wrong now; empty: nothing
  std::vector<std::string> notes;  // what to do, and what this does not try
};

// Whether a press at (x, y), in fractions of the picture's height, is on its button that closes it.
bool closes_device_panel(const DevicePanel& panel, render::Extent picture, const Look& look, double x,
                         double y);

}  // namespace fulcrum::ui
