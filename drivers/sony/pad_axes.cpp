#include "drivers/sony/pad_axes.h"

#include <algorithm>
#include <cmath>

#include "drivers/rate/rate_control.h"

namespace fulcrum::sony {
namespace {

constexpr double kRests = 0.1;  // of a stick's way
constexpr std::uint32_t kL1 = 1U << 8, kR1 = 1U << 9, kTouchpad = 1U << 17;

// -1 to 1, and exactly 0 where the stick rests.
double pushed(std::uint8_t reading) {
  return beyond_rest(std::clamp((reading - 128) / 127.0, -1.0, 1.0), kRests);
}

double pulled(std::uint8_t reading) {
  return beyond_rest(reading / 255.0, kRests);
}

// What has the tool turn just so fast, as far as rate control goes.
double push_of(double rate) {
  return std::copysign(std::sqrt(std::min(std::abs(rate) / RateControlDesc().full_turn, 1.0)), rate);
}

}  // namespace

PushedAxes axes_of(const Pad& pad, PadGyro& gyro) {
  const double roll = ((pad.keys & kL1) != 0 ? 1.0 : 0.0) - ((pad.keys & kR1) != 0 ? 1.0 : 0.0);
  PushedAxes axes;
  axes.way = {pushed(pad.left_x), -pushed(pad.left_y), pulled(pad.l2) - pulled(pad.r2)};
  axes.turn = {pushed(pad.right_y), pushed(pad.right_x), roll};
  const bool turns = (pad.keys & kTouchpad) != 0;
  const Vec3 rate = gyro.rate(pad.gyro, turns);
  if (turns) axes.turn = {push_of(rate.x()), push_of(rate.y()), push_of(rate.z())};
  axes.buttons = pad.keys >> 4;
  return axes;
}

}  // namespace fulcrum::sony
