#include "engine/app/prepare/capabilities.h"

#include <nlohmann/json.hpp>

#include "engine/scenario/content.h"
#include "engine/scenario/load.h"
#include "haptics/math/number_text.h"

namespace fulcrum::app {
namespace {

int axes_sensed(const DeviceDesc& device) {
  return device.senses_rotation ? 6 : 3;
}

std::string what_it_renders(const DeviceDesc& device) {
  if (!device.renders_force && !device.renders_torque) return "; pushes nothing back";
  std::string words;
  if (device.renders_force) words += "; pushes on 3 with " + number_text(device.max_force) + " N";
  if (device.renders_torque) words += "; twists about 3 with " + number_text(device.max_torque) + " N m";
  words += device.firmware_watchdog > 0
               ? "; its firmware lets go after " + number_text(device.firmware_watchdog) + " s of silence"
               : "; no firmware watchdog is known";
  return words;
}

std::string what_vibrates(const VibrotactileDesc& vibrators) {
  std::string names;
  for (const ChannelDesc& channel : vibrators.channels) {
    names.append(names.empty() ? "" : ", ").append(channel.name);
    names.append(" (").append(name_of(channel.kind)) += ')';
  }
  return "vibrates: " + names;
}

constexpr const char* kKnowsWhere = "knows where it is held, by a strip";

}  // namespace

std::string capabilities_in_words(const DeviceDesc& device) {
  std::string words = "senses " + std::to_string(axes_sensed(device)) + " axes";
  if (device.sample_rate_Hz > 0) words += ", " + number_text(device.sample_rate_Hz) + " times a second";
  words += what_it_renders(device);
  if (device.vibrotactile) words += "; " + what_vibrates(*device.vibrotactile);
  if (device.strip) words.append("; ").append(kKnowsWhere);
  return words;
}

std::string capabilities_in_words(const DeviceListing& listing, const DeviceDesc& device) {
  if (!listing.beside_alone) return capabilities_in_words(device);
  return device.vibrotactile ? what_vibrates(*device.vibrotactile) : kKnowsWhere;
}

nlohmann::ordered_json capabilities_as_json(const DeviceDesc& device) {
  using Json = nlohmann::ordered_json;
  const auto known = [](double value) { return value > 0 ? Json(value) : Json(nullptr); };
  Json channels = Json::array();
  if (device.vibrotactile)
    for (const ChannelDesc& channel : device.vibrotactile->channels)
      channels.push_back({{"name", channel.name}, {"kind", name_of(channel.kind)}});
  return {
      {"axes_sensed", axes_sensed(device)},
      {"renders_force", device.renders_force},
      {"renders_torque", device.renders_torque},
      {"max_force_N", device.renders_force ? device.max_force : 0.0},
      {"max_torque_Nm", device.renders_torque ? device.max_torque : 0.0},
      {"bandwidth_Hz", device.renders_force || device.renders_torque ? known(device.bandwidth_Hz) : nullptr},
      {"sample_rate_Hz", known(device.sample_rate_Hz)},
      {"workspace_m", {device.workspace.x(), device.workspace.y(), device.workspace.z()}},
      {"firmware_watchdog_s", known(device.firmware_watchdog)},
      {"channels", std::move(channels)},
      {"strip", device.strip.has_value()}};
}

std::optional<DeviceDesc> figures_of(const DeviceListing& listing) {
  if (listing.name == "mouse") return MouseDevice::mouse_desc();
  if (listing.table.empty()) return std::nullopt;
  const auto files = scenario::device_files(scenario::content_roots());
  const auto file = files.find(listing.table);
  if (file == files.end()) return std::nullopt;
  const scenario::Checked<DeviceDesc> device = scenario::load_device(file->second);
  if (!device) return std::nullopt;
  return *device;
}

}  // namespace fulcrum::app
