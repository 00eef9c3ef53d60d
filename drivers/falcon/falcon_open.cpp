// How a Falcon comes from libusb and from the file with its firmware; the rest of FalconBus knows neither.

#include "drivers/falcon/falcon_bus.h"
#include "drivers/falcon/falcon_firmware.h"
#include "drivers/permission.h"

namespace fulcrum::falcon {
namespace {

Result<std::unique_ptr<usb::UsbPort>> open_port(OwnDevice& own) {
  const std::vector<usb::UsbPlace> all = usb::find_usb(kIds);
  std::vector<usb::UsbPlace> places = all;
  own.keep_own(places);
  if (places.empty()) return Error{"none is plugged in: plug one in, and its power, too."};
  Error why = not_permitted(places.front().path);
  for (const usb::UsbPlace& place : places) {
    if (!place.permitted) continue;
    Result<std::unique_ptr<usb::UsbPort>> port =
        usb::open_usb(place, {.interface = 0, .in = 0x81, .out = 0x02});
    if (port) {
      own.be(place, all);
      return port;
    }
    why = port.error();
  }
  return why;
}

}  // namespace

// Where there is a file with the firmware, the device is not asked whether it needs it.
std::string why_no_falcon() {
  const std::vector<usb::UsbPlace> places = usb::find_usb(kIds);
  if (!places.empty() && places.front().permitted && find_firmware()) return {};
  OwnDevice any;
  Result<std::unique_ptr<usb::UsbPort>> port = open_port(any);
  if (!port) return port.error().sentence;
  FalconLine line(**port);
  FalconBoot boot(&find_firmware);
  while (boot.advance(line) == FalconBoot::State::going) {
  }
  return boot.why();
}

Result<std::unique_ptr<FalconBus>> FalconBus::open(Own& own) {
  Result<std::unique_ptr<usb::UsbPort>> port = open_port(own);
  if (!port) return port.error();
  return std::make_unique<FalconBus>(std::move(*port), &find_firmware);
}

}  // namespace fulcrum::falcon
