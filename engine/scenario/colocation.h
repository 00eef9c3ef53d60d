#pragma once
// Where a device stands in the space of a headset, as `fulcrum run SCENE --xr --colocate` has measured it. It
// is kept for each device, person and space.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scenario/fault.h"
#include "engine/scenario/key_visitor.h"
#include "haptics/math/pose.h"

namespace fulcrum::scenario {

struct Colocation {
  static constexpr std::size_t kMostPoints = 12;

  std::string device;             // as --device takes it
  std::string space;              // as --xr-space takes it
  Pose X_LD;                      // the device's base D in the headset's space L
  std::vector<double> residuals;  // (n) m, of each point that was touched

  double rms() const;  // m, of the residuals
};

// The file's keys.
void describe_colocation_file(KeyVisitor& visitor, Colocation& colocation);

// The file's text.
std::string colocation_text(const Colocation& colocation);

// Where it is kept: calibration/DEVICE.xr-SPACE.yaml in the person's configuration. It need not be there.
// Empty: neither XDG_CONFIG_HOME nor HOME says where that is.
std::filesystem::path colocation_file(std::string_view device, std::string_view space);

// The file of a device and a space. One that cannot be read, or is of another device or space, is refused,
// with what would mend it.
Checked<Colocation> load_colocation(const std::filesystem::path& file, std::string_view device,
                                    std::string_view space);

}  // namespace fulcrum::scenario
