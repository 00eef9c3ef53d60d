#pragma once
// A Novint Falcon on its USB port. It answers a packet of motors' values with one of counts, about a thousand
// times a second; nothing is known of what its firmware does when packets stay away.

#include <deque>
#include <memory>
#include <optional>
#include <span>
#include <string>

#include "drivers/falcon/falcon_arm.h"
#include "drivers/falcon/falcon_boot.h"
#include "drivers/falcon/falcon_line.h"
#include "drivers/force/force_bus.h"
#include "drivers/hid/hid_id.h"
#include "drivers/own_device.h"
#include "drivers/usb/usb_port.h"
#include "haptics/loop/age_clock.h"

namespace fulcrum::falcon {

inline constexpr hid::HidId kIds[] = {{0x0403, 0xcb48}};
inline std::span<const hid::HidId> usb_ids() {
  return kIds;
}

// Why none can be had now; empty: one is there, and its firmware is in it or at hand.
std::string why_no_falcon();

class FalconBus final : public ForceBus {
public:
  using Own = OwnDevice;
  // Errors: it is not there, or cannot be opened.
  static Result<std::unique_ptr<FalconBus>> open(Own& own);
  FalconBus(std::unique_ptr<usb::UsbPort> port, FalconBoot::Firmware firmware);

  Turn exchange(const DeviceCommand& command, DeviceSample& sample) override;
  bool starts() const override { return boot_.state() == FalconBoot::State::going; }
  std::string trouble() const override;

private:
  Turn start();
  void take(std::span<const std::uint8_t> bytes, std::optional<FalconSays>& says);
  void drop();
  // The newest packet within a few ms. False: the device is gone.
  bool listen(std::optional<FalconSays>& says);

  std::unique_ptr<usb::UsbPort> port_;
  FalconLine line_;
  FalconBoot boot_;
  PacketStream packets_;
  // Where the grip was when the last packet was answered: only then may motors push. None: they rest.
  std::optional<Stance> stance_;
  bool homed_ = false;
  bool answered_ = false;
  bool impossible_ = false;                      // what its counts say
  std::deque<AgeClock::time_point> unanswered_;  // when each packet was sent that may still be answered
  AgeClock::time_point asked_{};                 // when the packet was that is answered by what it said last
  AgeClock::time_point heard_{};                 // when it last said anything, once it has started
};

}  // namespace fulcrum::falcon
