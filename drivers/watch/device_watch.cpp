#include "drivers/watch/device_watch.h"

#include <dirent.h>
#include <unistd.h>

#include <algorithm>
#include <utility>

namespace fulcrum {
namespace {

// In their order; none where there is no such folder.
std::vector<std::string> names_in(const std::string& folder) {
  std::vector<std::string> names;
  DIR* const open = opendir(folder.c_str());
  if (open == nullptr) return names;
  while (const dirent* const entry = readdir(open))
    if (entry->d_name[0] != '.') names.emplace_back(entry->d_name);
  closedir(open);
  std::ranges::sort(names);
  return names;
}

void add_nodes(const std::string& folder, const std::vector<std::string>& names, std::string& text) {
  for (const std::string& name : names) {
    text.append(name);
    text += access((folder + name).c_str(), R_OK | W_OK) == 0 ? "+ " : "- ";
  }
}

}  // namespace

std::string plugged_in() {
  std::string text;
  add_nodes("/dev/", names_in("/sys/class/hidraw"), text);
  add_nodes("/dev/input/", names_in("/sys/class/input"), text);
  for (const std::string& name : names_in("/sys/bus/usb/devices")) text.append(name) += ' ';
  for (const std::string& bus : names_in("/dev/bus/usb")) {
    const std::string folder = "/dev/bus/usb/" + bus + "/";
    text.append(bus) += ' ';
    add_nodes(folder, names_in(folder), text);
  }
  for (const std::string& name : names_in("/sys/class/sound")) text.append(name) += ' ';
  return text;
}

DeviceWatch::DeviceWatch(List list, List services)
    : list_(std::move(list)),
      services_(std::move(services)),
      seen_(plugged_in()),
      listed_(seen_),
      devices_(list_()) {}

std::vector<DeviceListing> DeviceWatch::look() {
  const std::string before = std::exchange(seen_, plugged_in());
  if (seen_ == listed_ || seen_ != before) return {};
  listed_ = seen_;
  const std::vector<DeviceListing> were = std::exchange(devices_, list_());
  std::vector<DeviceListing> changed;
  for (const DeviceListing& device : devices_)
    if (std::ranges::find(were, device) == were.end()) changed.push_back(device);
  return changed;
}

std::vector<DeviceListing> DeviceWatch::ask_services() {
  const std::vector<DeviceListing> before = std::exchange(asked_, services_());
  std::vector<DeviceListing> changed;
  if (asked_ != before) return changed;
  for (const DeviceListing& device : asked_) {
    const auto was = std::ranges::find(devices_, device.name, &DeviceListing::name);
    if (was == devices_.end() || *was == device) continue;
    *was = device;
    changed.push_back(device);
  }
  return changed;
}

}  // namespace fulcrum
