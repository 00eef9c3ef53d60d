#pragma once
// A device with motors, on whatever bus: turn after turn, what its motors are to do for where its handle is.

#include <string>

#include "haptics/device/device.h"

namespace fulcrum {

// Used by one thread at a time, which may wait in it.
class ForceBus {
public:
  virtual ~ForceBus() = default;

  enum class Turn {
    fresh,  // `sample` is new
    none,   // nothing came in time, or what came was refused; `sample` is as it was
    lost    // the device is gone
  };
  // Sends the command, then takes the newest sample, for which it waits a few ms at most. sample.age: how old
  // it was when it came.
  virtual Turn exchange(const DeviceCommand& command, DeviceSample& sample) = 0;
  // Why nothing comes though the device is there, and what would cure it; empty: it is not known to be so.
  virtual std::string trouble() const { return {}; }
  // It is being made ready, which may take longer than a first sample does, and ends by itself.
  virtual bool starts() const { return false; }
};

}  // namespace fulcrum
