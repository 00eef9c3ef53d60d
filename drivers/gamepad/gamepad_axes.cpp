#include "drivers/gamepad/gamepad_axes.h"

#include "haptics/loop/age_clock.h"

namespace fulcrum {
namespace {

// Of a stick's and a trigger's way. Cheap sticks come to rest within a tenth of it.
constexpr double kRests = 0.1;

double pushed(double part) {
  return beyond_rest(part, kRests);
}

}  // namespace

PushedAxes axes_of(const GamepadReading& pad) {
  const double roll = (pad.left_bumper ? 1.0 : 0.0) - (pad.right_bumper ? 1.0 : 0.0);
  PushedAxes axes;
  axes.way = {pushed(pad.left_x), pushed(pad.left_y), pushed(pad.left_trigger) - pushed(pad.right_trigger)};
  axes.turn = {-pushed(pad.right_y), pushed(pad.right_x), roll};
  return axes;
}

void GamepadAxes::tell(const PushedAxes& axes, bool connected) noexcept {
  told_.draft() = {axes, AgeClock::now_ns(), connected};
  told_.publish();
}

AxesReading GamepadAxes::read() noexcept {
  const Told& told = told_.newest();
  AxesReading reading{.axes = told.axes, .connected = told.connected};
  if (1e-9 * static_cast<double>(AgeClock::now_ns() - told.at_ns) > kKept)
    reading.axes.way = reading.axes.turn = Vec3::Zero();
  return reading;
}

}  // namespace fulcrum
