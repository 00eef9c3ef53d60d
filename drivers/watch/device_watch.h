#pragma once
// Tells which devices come and go. The drivers are asked anew only once the kernel shows other devices than
// before and has shown the same ones twice: who lists a device in the moment in which it vanishes stumbles,
// and one that has just come is not yet permitted. A service is asked by itself, and is told once it has said
// the same twice.

#include <functional>
#include <string>
#include <vector>

#include "drivers/registry.h"

namespace fulcrum {

// What the kernel's files show to be there on USB, as HID and for sound, and which of their nodes you may
// open, as a text: another one where anything of it has changed.
std::string plugged_in();

class DeviceWatch {
public:
  using List = std::function<std::vector<DeviceListing>()>;
  // services: those of the list of which the kernel shows nothing.
  explicit DeviceWatch(
      List list, List services = [] { return std::vector<DeviceListing>(); });

  const std::vector<DeviceListing>& devices() const { return devices_; }
  // To be called every now and then. Those of the devices that are now there, gone, or there in another way.
  std::vector<DeviceListing> look();
  // The same of the services, which are asked each time. To be called more seldom.
  std::vector<DeviceListing> ask_services();

private:
  List list_, services_;
  std::string seen_, listed_;  // plugged_in() of the last look; of the last listing
  std::vector<DeviceListing> devices_;
  std::vector<DeviceListing> asked_;  // what the services said last
};

}  // namespace fulcrum
