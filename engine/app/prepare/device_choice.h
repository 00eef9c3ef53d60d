#pragma once
// What --device stands for.

#include <filesystem>
#include <string>
#include <vector>

#include "haptics/math/result.h"

namespace fulcrum::app {

struct DeviceChoice {
  std::string device;                  // as the registry and results have it
  std::vector<std::string> overrides;  // KEY=VALUE: where the scenario takes its figures from
  std::filesystem::path calibration;   // of a device that a person holds, where it was calibrated; else empty
};

// Errors: there is no such device.
Result<DeviceChoice> choose_device(const std::string& asked);

}  // namespace fulcrum::app
