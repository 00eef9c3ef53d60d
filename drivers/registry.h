#pragma once
// Which devices there are, and for those that are not, why: `fulcrum devices`.

#include <string>
#include <vector>

namespace fulcrum {

struct DeviceListing {
  std::string name;  // as --device takes it
  std::string what;  // what it is, one line
  bool present = false;
  std::string reason;  // why not, and what would change that; empty when present
};

// no_window_reason: why no window can be opened; empty if one can.
std::vector<DeviceListing> list_devices(const std::string& no_window_reason);

}  // namespace fulcrum
