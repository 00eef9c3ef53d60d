#pragma once
// A device that is connected and always says the same pose, as one does whose sensors are stuck, or that was
// not homed.

#include <cstdint>

#include "haptics/device/device.h"

namespace fulcrum::app {

class StillHandle {
public:
  static constexpr double kLong = 3.0;  // s; a hand that holds a device is never so quiet
  static constexpr const char* kSentence =
      "The device is connected, but its handle has not moved at all for 3 s. If it was moved: home or "
      "calibrate it, and "
      "look at its power and its cable.";

  explicit StillHandle(double tick_s);
  // Each tick. True: it has been still for so long now, which is said once.
  bool note(const DeviceSample& sample);
  bool is_still() const { return ticks_ >= long_; }

private:
  std::int64_t long_;       // ticks
  std::int64_t ticks_ = 0;  // without a change
  Pose X_DH_;
};

}  // namespace fulcrum::app
