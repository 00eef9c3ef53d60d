#pragma once
// What a HID device without motors says and is told: bytes and their meaning, without a bus. Any bytes may
// come; nothing here throws, allocates or waits.

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>

#include "drivers/rate/axes_source.h"
#include "haptics/device/vibrotactile_desc.h"

namespace fulcrum::hid {

class HidProtocol {
public:
  static constexpr std::size_t kLongestReport = 128;
  using Report = std::array<std::uint8_t, kLongestReport>;

  virtual ~HidProtocol() = default;

  // report: as read, its number first. False: no such report is known, it is too short or its checksum is
  // wrong; then `axes` is what it was.
  virtual bool decode(std::span<const std::uint8_t> report, PushedAxes& axes) noexcept = 0;
  // The report that has the channels vibrate so, of the length that is answered; 0: the device has none.
  virtual std::size_t encode(const ChannelDrives& /*drives*/, Report& /*report*/) noexcept { return 0; }
  // Feature reports that are to be read once it is open, number and length, and what was read.
  struct Feature {
    std::uint8_t number = 0;
    std::size_t length = 0;
  };
  virtual std::span<const Feature> features() const noexcept { return {}; }
  virtual void learn(std::span<const std::uint8_t> /*feature*/) noexcept {}
  // A report that it is to be sent besides, of the length that is answered; 0: none now. It is asked for
  // before each report of the channels, by the thread that sends, while another one decodes.
  virtual std::size_t ask(Report& /*report*/) noexcept { return 0; }
  struct Pace {
    int write_ms = 4;     // from one report that is sent to the next
    int repeat_ms = 200;  // one that vibrates is sent again: it may have been missed
  };
  virtual Pace pace() const noexcept { return {}; }
  // Whether reports come all the time, or only while something is pushed.
  virtual bool streams() const noexcept = 0;
};

}  // namespace fulcrum::hid
