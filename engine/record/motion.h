#pragma once
// A recorded handle motion for --device replay:FILE, out of a tape or a trace.csv.

#include <filesystem>
#include <vector>

#include "haptics/device/device.h"
#include "haptics/math/result.h"

namespace fulcrum::record {

struct HandleMotion {
  enum class Space {
    device,  // X_DH as the device gave it (tape)
    scene    // X_WH less its drift: the samples' X_DH holds the pose in the scene (trace);
             // MappingDesc::handle_in_device() undoes it
  };

  Space space = Space::device;
  double tick_s = 1e-3;
  std::vector<DeviceSample> samples;  // one a tick, at least one; a lost tick repeats the sample before it
  bool complete = true;               // false: the file ends early
};

// What the file is, its first bytes say.
Result<HandleMotion> read_motion(const std::filesystem::path& path);

}  // namespace fulcrum::record
