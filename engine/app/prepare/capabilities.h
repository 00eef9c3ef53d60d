#pragma once
// What a device can do, from its table: the same words wherever a person asks.

#include <nlohmann/json_fwd.hpp>
#include <optional>
#include <string>

#include "drivers/registry.h"
#include "haptics/device/device.h"

namespace fulcrum::app {

// "senses 6 axes, 1000 times a second; pushes on 3 with 5 N; its firmware lets go after 0.5 s".
std::string capabilities_in_words(const DeviceDesc& device);

// The same of one that is listed. What stands beside another device alone has no axes of its own to tell of.
std::string capabilities_in_words(const DeviceListing& listing, const DeviceDesc& device);

nlohmann::ordered_json capabilities_as_json(const DeviceDesc& device);

// The figures of a device that is listed; none where it has none of its own, such as a replay. An installed
// table that is wrong counts as none.
std::optional<DeviceDesc> figures_of(const DeviceListing& listing);

}  // namespace fulcrum::app
