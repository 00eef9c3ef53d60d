#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>

#include "drivers/registry.h"
#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/commands/commands.h"
#include "engine/ui/window.h"

namespace fulcrum::app {

namespace {

struct DevicesOptions {
  bool json = false;
  bool udev = false;
};

int devices_command(const DevicesOptions& options) {
  if (options.udev) {
    std::fputs(udev_rules().c_str(), stdout);
    return kCompleted;
  }
  const std::vector<DeviceListing> devices = list_devices(ui::why_no_window());
  if (options.json) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const DeviceListing& d : devices)
      all.push_back(
          {{"name", d.name},
           {"what", d.what},
           {"present", d.present},
           {"reason", d.present ? nlohmann::ordered_json(nullptr) : nlohmann::ordered_json(d.reason)}});
    std::printf("%s\n", all.dump(2).c_str());
    return kCompleted;
  }
  std::size_t width = 0;
  for (const DeviceListing& d : devices) width = std::max(width, d.name.size());
  for (const DeviceListing& d : devices) {
    std::printf("%s%s  %s  %s\n", bold(d.name).c_str(), std::string(width - d.name.size(), ' ').c_str(),
                d.present ? "there    " : "not there", d.what.c_str());
    if (!d.present) std::printf("%s  %s\n", std::string(width, ' ').c_str(), dim(d.reason).c_str());
  }
  return kCompleted;
}

}  // namespace

void add_devices(Program& program) {
  const auto options = std::make_shared<DevicesOptions>();
  program.add(
      "devices", "Which devices are there, and why others are not",
      [options](Arguments& arguments) {
        arguments.json("As JSON", options->json);
        arguments.flag("--udev", "Print the rules for udev that let you open them (tools/run --udev)",
                       options->udev);
      },
      [options] { return devices_command(*options); });
}

}  // namespace fulcrum::app
