#include <algorithm>
#include <chrono>
#include <cstdio>
#include <ctime>
#include <filesystem>
#include <memory>
#include <nlohmann/json.hpp>
#include <thread>

#include "drivers/registry.h"
#include "drivers/watch/device_watch.h"
#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/interrupt.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/commands/commands.h"
#include "engine/app/prepare/capabilities.h"
#include "engine/scenario/load.h"
#include "engine/ui/window.h"

namespace fulcrum::app {

namespace {

constexpr int kLooksPerService = 8;  // a service is asked every two seconds

struct DevicesOptions {
  bool json = false;
  bool udev = false;
  bool watch = false;
};

// The command that a reason asks for, which stands in it between backquotes; empty: an act is what helps.
std::string cure_in(const std::string& reason) {
  const std::size_t begin = reason.find('`');
  const std::size_t end = begin == std::string::npos ? begin : reason.find('`', begin + 1);
  return end == std::string::npos ? "" : reason.substr(begin + 1, end - begin - 1);
}

// What there is of a calibration, in a line; empty: nothing.
std::string calibration_text(const DeviceListing& device) {
  const std::filesystem::path file = scenario::kept_calibration(device.name);
  if (file.empty()) return {};
  const auto calibration = scenario::load_calibration(file);
  if (calibration && calibration->device == device.name) return "calibrated, as " + file.string() + " has it";
  return "its calibration, " + file.string() + ", cannot be used: `fulcrum calibrate " + device.name +
         " --forget` removes it";
}

nlohmann::ordered_json device_as_json(const DeviceListing& device) {
  using Json = nlohmann::ordered_json;
  const auto text = [](const std::string& said) { return said.empty() ? Json(nullptr) : Json(said); };
  const std::optional<DeviceDesc> figures = figures_of(device);
  return {{"name", device.name},
          {"what", device.what},
          {"present", device.present},
          {"reason", text(device.reason)},
          {"cure", text(cure_in(device.reason))},
          {"node", text(device.node)},
          {"permitted", device.permitted ? Json(*device.permitted) : Json(nullptr)},
          {"firmware", text(device.firmware)},
          {"calibration", text(scenario::kept_calibration(device.name).string())},
          {"capabilities", figures ? capabilities_as_json(*figures) : Json(nullptr)}};
}

// Where it is plugged in, and what of it is known there.
std::string place_of(const DeviceListing& device) {
  std::string place = device.node;
  if (!device.firmware.empty()) place += ", firmware " + device.firmware;
  return place;
}

void print_device(const DeviceListing& device, std::size_t width) {
  const std::size_t indent = width + 4;
  const auto beside = [indent](const std::string& text) { return in_lines(text, indent); };
  std::printf("  %s%s\n", bold(device.name).c_str(),
              beside(device.what).substr(device.name.size() + 2).c_str());
  if (const std::optional<DeviceDesc> figures = figures_of(device))
    std::printf("%s\n", dim(beside(capabilities_in_words(device, *figures))).c_str());
  if (const std::string place = place_of(device); !place.empty() && device.present)
    std::printf("%s\n", beside("at " + place).c_str());
  if (const std::string calibration = calibration_text(device); !calibration.empty())
    std::printf("%s\n", beside(calibration).c_str());
  if (!device.present) std::printf("%s\n", yellow(beside(device.reason)).c_str());
  if (const std::string cure = cure_in(device.reason); !cure.empty())
    std::printf("%s\n", beside("-> " + cure).c_str());
}

void print_group(const char* heading, const std::vector<DeviceListing>& devices, bool present) {
  std::size_t width = 0;
  for (const DeviceListing& device : devices) width = std::max(width, device.name.size());
  std::printf("%s\n", bold(heading).c_str());
  for (const DeviceListing& device : devices)
    if (device.present == present) print_device(device, width);
}

void list(bool json) {
  const std::vector<DeviceListing> devices = list_devices(ui::why_no_window());
  if (json) {
    nlohmann::ordered_json all = nlohmann::ordered_json::array();
    for (const DeviceListing& device : devices) all.push_back(device_as_json(device));
    std::printf("%s\n", all.dump(2).c_str());
    return;
  }
  print_group("There", devices, true);
  if (std::ranges::find(devices, false, &DeviceListing::present) == devices.end()) return;
  std::printf("\n");
  print_group("Not there", devices, false);
}

std::string time_of_day() {
  const std::time_t now = std::time(nullptr);
  std::tm local{};
  localtime_r(&now, &local);
  char text[16];
  std::strftime(text, sizeof text, "%H:%M:%S", &local);
  return text;
}

// One line, in JSON too. False: nobody reads it any more.
bool tell_change(const DeviceListing& device, bool json) {
  if (json) {
    std::printf("%s\n", device_as_json(device).dump().c_str());
  } else {
    const std::string place = place_of(device);
    std::printf("%s  %s  %s%s%s\n", time_of_day().c_str(), device.present ? green("there").c_str() : "gone ",
                bold(device.name).c_str(), device.present && !place.empty() ? "  " : "",
                (device.present ? place : "  " + device.reason).c_str());
  }
  return std::fflush(stdout) == 0;
}

int watch(bool json) {
  catch_interrupts();
  const std::string no_window = ui::why_no_window();
  DeviceWatch devices([&no_window] { return list_devices(no_window); },
                      [&no_window] { return list_services(no_window); });
  bool read = true;
  const auto tell = [&read, json](const std::vector<DeviceListing>& changed) {
    for (const DeviceListing& device : changed) read = read && tell_change(device, json);
  };
  // What is plugged in now comes first, so that who starts late misses nothing.
  for (const DeviceListing& device : devices.devices())
    if (!device.node.empty()) read = read && tell_change(device, json);
  std::fprintf(stderr, "Watching for devices; Ctrl+C ends it.\n");
  for (int looks = 1; read && !interrupted(); ++looks) {
    std::this_thread::sleep_for(std::chrono::milliseconds(250));
    tell(devices.look());
    if (looks % kLooksPerService == 0) tell(devices.ask_services());
  }
  return kCompleted;
}

int devices_command(const DevicesOptions& options) {
  if (options.udev) {
    std::fputs(udev_rules().c_str(), stdout);
    return kCompleted;
  }
  if (options.watch) return watch(options.json);
  list(options.json);
  return kCompleted;
}

}  // namespace

void add_devices(Program& program) {
  const auto options = std::make_shared<DevicesOptions>();
  program.add(
      "devices", "Which devices are there, what they can do, and why others are not there",
      [options](Arguments& arguments) {
        arguments.json("As JSON", options->json);
        arguments.flag("--udev", "Print the rules for udev that let you open them (tools/run --udev)",
                       options->udev);
        arguments.flag("--watch", "Print a line whenever one comes or goes, until Ctrl+C", options->watch);
      },
      [options] { return devices_command(*options); });
}

}  // namespace fulcrum::app
