// Reference: none; any bytes as the reports of each device that is pushed. Invariants: axes are from -1 to 1,
// what is refused changes nothing, and what is sent is as long as its kind. A first byte of odd value has the
// checksum of a Bluetooth report put right, so that what stands behind it is reached.

#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <vector>

#include "drivers/dualsense/dualsense_protocol.h"
#include "drivers/dualshock4/dualshock4_protocol.h"
#include "drivers/hid/hid_bytes.h"
#include "drivers/spacemouse/spacemouse_protocol.h"

namespace fulcrum {
namespace {

void require(bool good) {
  if (!good) std::abort();
}

bool same(const PushedAxes& a, const PushedAxes& b) {
  return a.way == b.way && a.turn == b.turn && a.buttons == b.buttons;
}

void feed(hid::HidProtocol& device, std::span<const std::uint8_t> report) {
  PushedAxes axes;
  const PushedAxes before = axes;
  if (!device.decode(report, axes)) require(same(axes, before));
  for (const double value :
       {axes.way.x(), axes.way.y(), axes.way.z(), axes.turn.x(), axes.turn.y(), axes.turn.z()})
    require(std::abs(value) <= 1);
  device.learn(report);

  ChannelDrives drives{};
  if (report.size() >= sizeof drives) std::memcpy(drives.data(), report.data(), sizeof drives);
  hid::HidProtocol::Report sent{};
  const std::size_t length = device.encode(drives, sent);
  require(length == 0 || length == 32 || length == 63 || length == 78);
}

}  // namespace
}  // namespace fulcrum

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace fulcrum;
  if (size == 0) return 0;
  std::vector<std::uint8_t> report(data + 1, data + size);
  if (data[0] % 2 == 1 && report.size() >= 78)
    hid::put_u32(report, 74, hid::crc32(0xA1, std::span(report).first(74)));
  SpaceMouseProtocol mouse;
  feed(mouse, report);
  for (const sony::Link link : {sony::Link::usb, sony::Link::bluetooth}) {
    dualsense::DualSenseProtocol dualsense(link);
    feed(dualsense, report);
    dualshock4::DualShock4Protocol dualshock4(link);
    feed(dualshock4, report);
  }
  return 0;
}
