#pragma once
// What the kernel's files tell about the machine.

#include <cstdint>
#include <filesystem>
#include <functional>

#include "engine/app/doctor/finding.h"

namespace fulcrum::app {

// sys: where sysfs is mounted.
Finding governor_of(const std::filesystem::path& sys);
// Whether a device that is_ours may be put to sleep while it is used.
Finding usb_sleep_of(const std::filesystem::path& sys,
                     const std::function<bool(std::uint16_t vendor, std::uint16_t product)>& is_ours);

}  // namespace fulcrum::app
