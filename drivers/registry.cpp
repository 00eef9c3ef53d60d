#include "drivers/registry.h"

namespace fulcrum {

std::vector<DeviceListing> list_devices(const std::string& no_window_reason) {
  return {
      {"simulated", "a 6/3-DOF device in a simulated hand, for runs without a person", true, ""},
      {"simulated:MODEL", "the same with the figures of another device: content/devices/MODEL.yaml", true,
       ""},
      {"replay:FILE", "the handle motion of a recorded tape or trace.csv", true, ""},
      {"mouse", "six axes by dragging, in a window; no force", no_window_reason.empty(), no_window_reason},
  };
}

}  // namespace fulcrum
