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
  Result<hid::HidOpened> opened = hid::open_spoken(kFamily, signal);
  if (!opened) return opened.error();
  const auto again = [signal] {
    Result<hid::HidOpened> found = hid::open_spoken(kFamily, signal);
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

// Bus: of a device with motors that speaks HID, made of a port and the device's figures.
template <const hid::HidFamily& kFamily, class Bus>
Result<OpenDevice> open_hid_force(const std::string& /*argument*/, const DeviceOrder& order) {
  Result<std::unique_ptr<hid::HidPort>> port = hid::open_one(kFamily);
  if (!port) return port.error();
  const auto again = [desc = order.desc]() -> std::unique_ptr<ForceBus> {
    Result<std::unique_ptr<hid::HidPort>> found = hid::open_one(kFamily);
    return found ? std::make_unique<Bus>(std::move(*found), desc) : nullptr;
  };
  Result<std::unique_ptr<ForceDevice>> device =
      ForceDevice::start(order.desc, std::make_unique<Bus>(std::move(*port), order.desc), again);
  if (!device) return device.error();
  return OpenDevice{.device = std::move(*device)};
}

// Bus: of a device with motors that finds its device itself, or whose maker's library or service does.
template <class Bus>
Result<OpenDevice> open_force(const std::string& /*argument*/, const DeviceOrder& order) {
  Result<std::unique_ptr<Bus>> bus = Bus::open();
  if (!bus) return bus.error();
  const auto again = []() -> std::unique_ptr<ForceBus> {
    Result<std::unique_ptr<Bus>> found = Bus::open();
    return found ? std::move(*found) : nullptr;
  };
  Result<std::unique_ptr<ForceDevice>> device = ForceDevice::start(order.desc, std::move(*bus), again);
  if (!device) return device.error();
  return OpenDevice{.device = std::move(*device)};
}

}  // namespace fulcrum
