#pragma once
// Every screen that a person may see, as data: what the shipped scenarios, their devices and their scores
// fill them with at the most.

#include <string>
#include <vector>

#include "engine/ui/overlay_state.h"

namespace fulcrum::test {

struct Screen {
  std::string name;
  ui::OverlayState state;
};

// Of which nothing may be cut off, left out or covered, at the sizes that people use.
std::vector<Screen> screens();
ui::OverlayState screen(const std::string& name);

}  // namespace fulcrum::test
