#include "engine/app/prepare/device_choice.h"

#include "drivers/registry.h"
#include "engine/scenario/calibration.h"

namespace fulcrum::app {

Result<DeviceChoice> choose_device(const std::string& asked) {
  constexpr std::string_view simulated = "simulated:";
  const Result<DeviceName> name = read_device_name(asked);
  if (!name) return name.error();
  DeviceChoice choice{asked, {}, {}};
  if (name->moves.starts_with(simulated)) {
    choice.device = "simulated" + asked.substr(name->moves.size());
    choice.overrides.push_back("device.model=" + name->moves.substr(simulated.size()));
  }
  if (has_table(name->moves)) {
    choice.overrides.push_back("device.model=" + name->moves);
    choice.calibration = scenario::kept_calibration(name->moves);
  }
  if (!name->beside.empty()) choice.overrides.push_back("device.beside=" + table_of(name->beside));
  return choice;
}

}  // namespace fulcrum::app
