#pragma once
// The device that is to be tested, by the name that --device takes.

#include <memory>
#include <string>

#include "drivers/registry.h"
#include "haptics/math/result.h"

namespace fulcrum::app::device_test {

inline constexpr double kTick = 1e-3;  // s

struct Opened {
  OpenDevice open;
  bool simulated = false;
};

// Errors: there is no such device or it cannot be had now, its table is wrong, or it is none for this test.
Result<Opened> open_for_test(const std::string& name);

}  // namespace fulcrum::app::device_test
