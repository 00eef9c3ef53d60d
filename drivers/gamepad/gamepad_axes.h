#pragma once
// A gamepad without a driver of its own as axes: the window reads it, the haptic thread reads what is pushed.
//
//     left stick       way right and up         right stick      turn about up and right
//     right trigger    way away from the        left trigger     way toward the person
//                      person
//     right bumper     turn about the line of   left bumper      back
//                      sight, clockwise

#include <cstdint>

#include "drivers/rate/axes_source.h"
#include "haptics/loop/snapshot.h"

namespace fulcrum {

// Where its controls are. Sticks -1 to 1, right and up; triggers 0 to 1.
struct GamepadReading {
  double left_x = 0, left_y = 0, right_x = 0, right_y = 0;
  double left_trigger = 0, right_trigger = 0;
  bool left_bumper = false, right_bumper = false;
};

PushedAxes axes_of(const GamepadReading& pad);

class GamepadAxes final : public AxesSource {
public:
  // s: for so long a push counts that nobody renews, since a window that stands still reads no pad.
  static constexpr double kKept = 0.25;

  // Main thread, whenever it has looked.
  void push(const PushedAxes& axes) noexcept { tell(axes, true); }
  void lose() noexcept { tell({}, false); }

  AxesReading read() noexcept override;

private:
  struct Told {
    PushedAxes axes;
    std::int64_t at_ns = 0;
    bool connected = true;
  };
  void tell(const PushedAxes& axes, bool connected) noexcept;

  Snapshot<Told> told_;
};

}  // namespace fulcrum
