#include "engine/scenario/calibration.h"

#include <algorithm>
#include <system_error>

#include "engine/files/user_folders.h"
#include "engine/files/number_text.h"
#include "engine/scenario/describe.h"
#include "haptics/math/number_text.h"

namespace fulcrum::scenario {
namespace {

constexpr double kRounding = 1e-9;  // m, of what was written as text

std::string shortest(double value) {
  std::string text;
  append_number(text, value);
  return text;
}

std::string list_text(const Vec3& v) {
  return "[" + shortest(v.x()) + ", " + shortest(v.y()) + ", " + shortest(v.z()) + "]";
}

}  // namespace

void describe_calibration_file(KeyVisitor& visitor, Calibration& calibration) {
  visitor.version({"fulcrum", "", "version of the file's format", true}, kFormatVersion);
  visitor.word({"device", "", "that was calibrated, as --device takes it", true}, calibration.device);
  visitor.mapping({"workspace", "", "what a hand reached, in the device's frame"}, [&](KeyVisitor& inner) {
    ReachedWorkspace& workspace = calibration.workspace.emplace();
    inner.vector({"centre", "m", "its middle", true}, workspace.centre_D, kPosition);
    inner.vector({"half_extents", "m", "from there", true}, workspace.half_extents,
                 from_to(Calibration::kMinHalfExtent, 10));
  });
  visitor.optional_number({"handle_weight", "N", "what the mechanism leaves uncompensated"},
                          calibration.handle_weight, from_to(0, 1000));
  visitor.boolean({"left_handed", "", "scenes are mirrored, for a tool in the left hand"},
                  calibration.left_handed);
}

std::string calibration_text(const Calibration& calibration) {
  std::string text = "fulcrum: " + std::to_string(kFormatVersion) + "\n# Written by `fulcrum calibrate " +
                     calibration.device + "`.\ndevice: " + calibration.device + "\n";
  if (calibration.workspace)
    text += "workspace: {centre: " + list_text(calibration.workspace->centre_D) +
            ", half_extents: " + list_text(calibration.workspace->half_extents) + "}\n";
  if (calibration.handle_weight) text += "handle_weight: " + shortest(*calibration.handle_weight) + "\n";
  if (calibration.left_handed) text += "left_handed: true\n";
  return text;
}

std::filesystem::path calibration_file(std::string_view device) {
  std::filesystem::path folder = config_folder();
  if (folder.empty()) return folder;
  return folder / "calibration" / (std::string(device) + ".yaml");
}

std::filesystem::path kept_calibration(std::string_view device) {
  std::filesystem::path file = calibration_file(device);
  if (file.empty()) return file;
  std::error_code ignored;
  const auto type = std::filesystem::symlink_status(file, ignored).type();
  return type == std::filesystem::file_type::not_found ? std::filesystem::path() : file;
}

double max_handle_weight(const DeviceDesc& table) {
  return std::min(Calibration::kMaxWeightShare * table.max_force, Calibration::kMaxWeight);
}

Result<DeviceDesc> calibrated(const DeviceDesc& table, const Calibration& calibration) {
  DeviceDesc device = table;
  if (calibration.workspace) {
    const auto& [centre_D, half_extents] = *calibration.workspace;
    const Vec3 beyond = centre_D.cwiseAbs() + half_extents - table.workspace;
    if (beyond.maxCoeff() > kRounding)
      return Error{"its workspace reaches " + fulcrum::number_text(1e3 * beyond.maxCoeff()) +
                   " mm farther than that of the device's table"};
    device.name += ", calibrated";
    device.workspace_centre = centre_D;
    device.workspace = half_extents;
  }
  if (calibration.handle_weight) {
    const double most = max_handle_weight(table);
    if (*calibration.handle_weight > most)
      return Error{"its handle_weight is " + shortest(*calibration.handle_weight) + " N, and at most " +
                   fulcrum::number_text(most) + " N may hold up the handle of this device"};
    device.handle_weight = *calibration.handle_weight;
  }
  return device;
}

}  // namespace fulcrum::scenario
