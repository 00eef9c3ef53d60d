#pragma once
// What an effect does with the device's vibrators as long as a scene runs. What it tells them in a tick is a
// VibrotactileCommand.

#include <optional>

#include "haptics/device/vibrotactile_desc.h"
#include "haptics/math/linear.h"

namespace fulcrum {

struct ChannelUse {
  VibrotactileSignal signal;
  std::optional<Vec3> axis_W{};  // (3), of a motion in the scene that the levels tell of; need not be unit
};

}  // namespace fulcrum
