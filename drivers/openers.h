#pragma once
// How devices of each kind are opened, for the list of them.

#include <memory>
#include <string>
#include <utility>

#include "drivers/force/force_device.h"
#include "drivers/hid/hid_family.h"
#include "drivers/hid/hid_link.h"
#include "drivers/registry.h"

namespace fulcrum {

// A handle that moves as fast as the axes are pushed.
inline OpenDevice by_axes(std::shared_ptr<AxesSource> axes, const DeviceOrder& order) {
  auto device = std::make_unique<RateDevice>(order.desc, std::move(axes), order.X_DH, order.tick_s);
  RateDevice* const rate = device.get();
  return OpenDevice{.device = std::move(device), .rate = rate};
}

template <const hid::HidFamily& kFamily>
std::string why_no_hid(const std::string& /*no_window_reason*/) {
  const Result<hid::HidPlace> place = hid::place_of(kFamily);
  return place ? "" : place.error().sentence;
}

// signal: what its channels are to render.
template <const hid::HidFamily& kFamily>
Result<std::shared_ptr<AxesSource>> hid_axes(const VibrotactileSignal& signal) {
  const auto own = std::make_shared<OwnDevice>();
  Result<hid::HidOpened> opened = hid::open_spoken(kFamily, signal, *own);
  if (!opened) return opened.error();
  const auto again = [signal, own] {
    Result<hid::HidOpened> found = hid::open_spoken(kFamily, signal, *own);
    return found ? std::move(*found) : hid::HidOpened();
  };
  return std::shared_ptr<AxesSource>(std::make_shared<hid::HidLink>(std::move(*opened), again));
}

// kAxes: as hid_axes().
template <auto kAxes>
Result<OpenDevice> open_axes(const std::string& /*argument*/, const DeviceOrder& order) {
  Result<std::shared_ptr<AxesSource>> axes = kAxes(order.signal.value_or(VibrotactileSignal()));
  if (!axes) return axes.error();
  return by_axes(std::move(*axes), order);
}

// open: a Result of a pointer to its bus, now and whenever it is looked for again.
template <class Open>
Result<OpenDevice> started(const DeviceOrder& order, Open open) {
  auto bus = open();
  if (!bus) return bus.error();
  const auto again = [open]() -> std::unique_ptr<ForceBus> {
    auto found = open();
    return found ? std::move(*found) : nullptr;
  };
  Result<std::unique_ptr<ForceDevice>> device = ForceDevice::start(order.desc, std::move(*bus), again);
  if (!device) return device.error();
  return OpenDevice{.device = std::move(*device)};
}

// Bus: of a device with motors that speaks HID, made of a port and the device's figures.
template <const hid::HidFamily& kFamily, class Bus>
Result<OpenDevice> open_hid_force(const std::string& /*argument*/, const DeviceOrder& order) {
  const auto own = std::make_shared<OwnDevice>();
  return started(order, [desc = order.desc, own]() -> Result<std::unique_ptr<Bus>> {
    Result<std::unique_ptr<hid::HidPort>> port = hid::open_one(kFamily, *own);
    if (!port) return port.error();
    return std::make_unique<Bus>(std::move(*port), desc);
  });
}

// Bus: of a device with motors that finds its device itself. Bus::Own: by what it finds the same one again.
template <class Bus>
Result<OpenDevice> open_own_force(const std::string& /*argument*/, const DeviceOrder& order) {
  const auto own = std::make_shared<typename Bus::Own>();
  return started(order, [own] { return Bus::open(*own); });
}

// Bus: of a device with motors that its maker's library finds, which knows which one it is.
template <class Bus>
Result<OpenDevice> open_force(const std::string& /*argument*/, const DeviceOrder& order) {
  return started(
      order, [] { return Bus::open(); });
}

}  // namespace fulcrum
