#pragma once
// What `fulcrum calibrate` has measured of a device that a person holds. It is kept for each device and
// person, and takes the place of the figures of the device's table, within them: a table bounds what is safe.

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

#include "engine/scenario/key_visitor.h"
#include "haptics/device/device.h"
#include "haptics/math/result.h"

namespace fulcrum::scenario {

struct ReachedWorkspace {
  Vec3 centre_D = Vec3::Zero();      // (3) m
  Vec3 half_extents = Vec3::Zero();  // (3) m
};

struct Calibration {
  // What holds the handle up is no longer there for the scene: half of the largest force at most, and no more
  // than a weighing can tell.
  static constexpr double kMaxWeightShare = 0.5, kMaxWeight = 1;  // N
  static constexpr double kMinHalfExtent = 0.02;                  // m, of a workspace

  std::string device;  // as --device takes it
  std::optional<ReachedWorkspace> workspace{};
  std::optional<double> handle_weight{};  // N
  bool left_handed = false;               // the person holds it in the left hand

  bool says_nothing() const { return !workspace && !handle_weight && !left_handed; }
};

// The file's keys.
void describe_calibration_file(KeyVisitor& visitor, Calibration& calibration);

// The file's text.
std::string calibration_text(const Calibration& calibration);

// Where that of a device is kept: calibration/NAME.yaml in the person's configuration. It need not be there.
// Empty: neither XDG_CONFIG_HOME nor HOME says where that is.
std::filesystem::path calibration_file(std::string_view device);

// The same where something is there, or nobody may see whether: what cannot be read is refused, and not
// passed over. Empty: there is none.
std::filesystem::path kept_calibration(std::string_view device);

// N, that may hold up the handle of a device.
double max_handle_weight(const DeviceDesc& table);

// The device's figures with what was measured, or why that cannot be, as the end of a sentence.
Result<DeviceDesc> calibrated(const DeviceDesc& table, const Calibration& calibration);

}  // namespace fulcrum::scenario
