#include "drivers/joycon/joycon_pair.h"

#include <algorithm>
#include <utility>

namespace fulcrum::joycon {

JoyConPair::JoyConPair(std::shared_ptr<AxesSource> left, std::shared_ptr<AxesSource> right)
    : left_(std::move(left)), right_(std::move(right)) {}

AxesReading JoyConPair::read() noexcept {
  AxesReading both = left_->read();
  const AxesReading right = right_->read();
  both.axes.way += right.axes.way;
  both.axes.turn += right.axes.turn;
  both.axes.buttons |= right.axes.buttons;
  both.age = std::max(both.age, right.age);
  both.connected = both.connected && right.connected;
  return both;
}

void JoyConPair::drive(const ChannelDrives& drives) noexcept {
  left_->drive(drives);
  right_->drive(drives);
}

}  // namespace fulcrum::joycon
