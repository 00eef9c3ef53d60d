#include "engine/app/cli/named_device.h"

#include <string_view>
#include <vector>

#include "engine/app/cli/terminal.h"
#include "engine/scenario/content.h"
#include "engine/scenario/load.h"
#include "engine/scenario/words.h"
#include "haptics/actuation/actuators.h"

namespace fulcrum::app {

std::optional<DeviceDesc> device_named(const std::string& name) {
  const auto files = scenario::device_files(scenario::content_roots());
  const auto found = files.find(name);
  if (found == files.end()) {
    std::vector<std::string_view> names;
    std::string all;
    for (const auto& [each, file] : files) {
      names.push_back(each);
      all += (all.empty() ? "" : ", ") + each;
    }
    complain("there is no device " + scenario::in_quotes(name) +
             scenario::did_you_mean(name, names, "there are " + all) + ".");
    return std::nullopt;
  }
  const scenario::Checked<DeviceDesc> device = scenario::load_device(found->second);
  if (!device) {
    complain(scenario::to_text(device.faults()));
    return std::nullopt;
  }
  return *device;
}

std::optional<DeviceDesc> pushing_device_named(const std::string& name) {
  std::optional<DeviceDesc> device = device_named(name);
  if (!device || Actuators::count(*device) > 0) return device;
  complain("the device '" + name + "' has no motors: this command needs one that pushes.");
  return std::nullopt;
}

}  // namespace fulcrum::app
