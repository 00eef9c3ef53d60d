#include "drivers/polhem/polhem_bus.h"

#include <algorithm>
#include <utility>

namespace fulcrum::polhem {
namespace {

constexpr int kWait_ms = 5;
constexpr int kMostWaiting = 64;  // reports; hidraw keeps 63 and drops what is newer

}  // namespace

PolhemBus::PolhemBus(std::unique_ptr<hid::HidPort> port, const DeviceDesc& desc)
    : port_(std::move(port)), arm_(desc) {}

// Switched on, the board counts from nought wherever its arm is, and no report tells whether it was told its
// place since. So it is pushed with only after this program has told it, when its button asked for that.
ForceBus::Turn PolhemBus::exchange(const DeviceCommand& command, DeviceSample& sample) {
  const BoardHears hears = calibrates_
                               ? encode_calibration(kRestCounts)
                               : encode_currents(calibrated_ ? arm_.currents(command) : std::array<int, 3>{});
  const bool told = port_->write(hears);
  std::array<std::uint8_t, 64> bytes{};
  std::optional<BoardSays> says;
  int wait = kWait_ms;
  for (int count = 0; count < kMostWaiting; ++count) {
    const int length = port_->read(bytes, wait);
    if (length < 0) return Turn::lost;
    if (length == 0) break;
    wait = 0;
    spoke_ = true;
    const std::optional<BoardSays> next = decode(std::span(bytes).first(static_cast<std::size_t>(length)));
    other_ = !next;
    if (next) says = next;
  }
  if (!says) return Turn::none;
  if (!told) return Turn::lost;  // what cannot be told to rest is not to be pushed with
  if (calibrates_ && !says->asks_calibration) calibrated_ = true;
  calibrates_ = says->asks_calibration;
  if (!calibrated_ || calibrates_) return Turn::none;
  sample.X_DH = arm_.X_DH(says->counts);
  sample.age = 0;
  sample.buttons = says->button ? 1u : 0u;
  return Turn::fresh;
}

std::string PolhemBus::trouble() const {
  if (other_)
    return "it is plugged in, and what it says is no Polhem's report: a board of three encoders is not known "
           "here.";
  if (spoke_)
    return "it is not calibrated: bring its arm to rest, upper link upright, lower link level, stylus "
           "straight, press the button on its board, and start again while it rests there.";
  return {};
}

}  // namespace fulcrum::polhem
