#pragma once
// What vibrates, as the haptic thread sees it: a pad's motors, voice coils on a sound card.

#include "haptics/device/vibrotactile_desc.h"

namespace fulcrum {

// Both are called once a tick: like a Device's read() and write() they neither block nor allocate, lock or
// throw.
class Vibrator {
public:
  virtual ~Vibrator() = default;
  virtual bool connected() noexcept = 0;  // false: it is lost
  virtual void drive(const VibrotactileCommand& command) noexcept = 0;
};

}  // namespace fulcrum
