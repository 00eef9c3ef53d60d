#pragma once

#include <optional>
#include <string>

#include "haptics/device/device.h"

namespace fulcrum::app {

// A file of content/devices, by name. Nothing if there is none such, which is said on stderr.
std::optional<DeviceDesc> device_named(const std::string& name);
// The same of one that has motors.
std::optional<DeviceDesc> pushing_device_named(const std::string& name);

}  // namespace fulcrum::app
