#pragma once
// Keys as axes: the window says which are down, the haptic thread reads what that pushes.

#include "drivers/rate/axes_source.h"
#include "haptics/loop/snapshot.h"

namespace fulcrum {

class KeyAxes final : public AxesSource {
public:
  // Main thread.
  void push(const PushedAxes& axes) noexcept {
    axes_.draft() = axes;
    axes_.publish();
  }

  AxesReading read() noexcept override { return {.axes = axes_.newest()}; }

private:
  Snapshot<PushedAxes> axes_;
};

}  // namespace fulcrum
