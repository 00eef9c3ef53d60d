#include "engine/app/device_test/opened.h"

#include <utility>

#include "engine/app/device_test/parts.h"
#include "engine/scenario/content.h"
#include "engine/scenario/load.h"
#include "engine/scenario/words.h"
#include "haptics/device/simulated_device.h"

namespace fulcrum::app::device_test {
namespace {

constexpr std::string_view kSimulated = "simulated:";
constexpr const char* kInWindow =
    "it needs a window, and this test is for devices that need none: try it with `fulcrum run`.";

Result<DeviceDesc> table_of(const std::string& name) {
  const auto files = scenario::device_files(scenario::content_roots());
  const auto file = files.find(name);
  if (file == files.end()) {
    std::vector<std::string_view> names;
    for (const auto& [each, path] : files) names.push_back(each);
    return Error{"There is no device " + scenario::in_quotes(name) +
                 scenario::did_you_mean(name, names, "there are " + scenario::joined(names)) + "."};
  }
  const scenario::Checked<DeviceDesc> device = scenario::load_device(file->second);
  if (!device) return Error{scenario::to_text(device.faults())};
  return *device;
}

// Its figures, with the channels of what vibrates beside it.
Result<DeviceDesc> figures_for(const DeviceName& parts) {
  Result<DeviceDesc> device = table_of(parts.moves);
  if (!device || parts.beside.empty()) return device;
  Result<DeviceDesc> beside = table_of(parts.beside);
  if (!beside) return beside;
  device->vibrotactile = std::move(beside->vibrotactile);
  return device;
}

Result<Opened> open_simulated_for_test(const std::string& model) {
  const Result<DeviceDesc> device = table_of(model);
  if (!device) return device.error();
  SimulatedDeviceDesc desc;
  desc.device = *device;
  desc.tick_s = kTick;
  return Opened{OpenDevice{.device = std::make_unique<SimulatedDevice>(desc, Pose{})}, true};
}

}  // namespace

Result<Opened> open_for_test(const std::string& name) {
  if (name.starts_with(kSimulated)) return open_simulated_for_test(name.substr(kSimulated.size()));
  if (name == "simulated")
    return Error{
        "Say which device is to be simulated, such as simulated:polhem: a test has no scenario that says "
        "it."};
  const Result<DeviceName> parts = read_device_name(name);
  if (!parts) return parts.error();
  if (std::optional<Error> refused = refuse_device(name, {kInWindow, true})) return *refused;
  if (!has_table(parts->moves))
    return Error{"'" + name +
                 "' is no device that can be tested: name one that is held, or simulated:MODEL."};
  Result<DeviceDesc> device = figures_for(*parts);
  if (!device) return device.error();
  DeviceOrder order{.desc = std::move(*device), .X_DH = {}, .tick_s = kTick};
  if (order.desc.vibrotactile) order.signal = signal_of_test(*order.desc.vibrotactile);
  Result<OpenDevice> open = open_device(name, order);
  if (!open) return open.error();
  return Opened{std::move(*open), false};
}

}  // namespace fulcrum::app::device_test
