#pragma once
// Keys as axes, where the keyboard is the device: which of them are down, and what that pushes.

#include <array>
#include <string>
#include <vector>

#include "drivers/rate/pushed_axes.h"

namespace fulcrum::app {

class ToolKeys {
public:
  // key, action: GLFW's. False: the key moves nothing.
  bool note(int key, int action);
  void let_go() { down_.fill(false); }
  // fine: a slow push, to touch with.
  PushedAxes axes(bool fine) const;

  // What each does, for the screen.
  static std::vector<std::string> help();

private:
  static constexpr std::size_t kKeys = 12;  // two for each axis
  std::array<bool, kKeys> down_{};
};

}  // namespace fulcrum::app
