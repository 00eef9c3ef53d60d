#pragma once
// Where pushed axes come from, and where vibration goes: a cap, a pad, keys.

#include <array>

#include "drivers/rate/pushed_axes.h"
#include "haptics/device/vibrotactile_desc.h"

namespace fulcrum {

using ChannelDrives =
    std::array<double, kMaxChannels>;  // (channels) 0 to 1, in the order of the device's table

struct AxesReading {
  PushedAxes axes;
  double age = 0;         // s, since it was known
  bool connected = true;  // false: the device is lost
};

// Both are called from the haptic thread, in turn, once a tick: like a Device's read() and write() they
// neither block nor allocate, lock or throw.
class AxesSource {
public:
  virtual ~AxesSource() = default;
  virtual AxesReading read() noexcept = 0;
  virtual void drive(const ChannelDrives&) noexcept {}
};

}  // namespace fulcrum
