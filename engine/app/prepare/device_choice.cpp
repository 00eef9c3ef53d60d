#include "engine/app/prepare/device_choice.h"

#include "drivers/registry.h"

namespace fulcrum::app {

Result<DeviceChoice> choose_device(const std::string& asked) {
  constexpr std::string_view simulated = "simulated:";
  if (asked.starts_with(simulated))
    return DeviceChoice{"simulated", {"device.model=" + asked.substr(simulated.size())}};
  const Result<DeviceName> name = read_device_name(asked);
  if (!name) return name.error();
  DeviceChoice choice{asked, {}};
  if (has_table(name->moves)) choice.overrides.push_back("device.model=" + name->moves);
  if (!name->beside.empty()) choice.overrides.push_back("device.beside=" + name->beside);
  return choice;
}

}  // namespace fulcrum::app
