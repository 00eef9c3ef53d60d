#include "engine/scenario/schema.h"

#include "engine/scenario/calibration.h"
#include "engine/scenario/describe.h"
#include "engine/scenario/schema_writer.h"

namespace fulcrum::scenario {

namespace {

std::string text_of(std::string_view title, const Describe& describe) {
  return write_schema(title, describe).dump(2) + "\n";
}

}  // namespace

std::string scenario_schema() {
  Scenario scenario;
  return text_of("Fulcrum scenario", [&](KeyVisitor& visitor) { describe_scenario(visitor, scenario); });
}

std::string hand_path_schema() {
  std::vector<Waypoint> waypoints;
  return text_of("Fulcrum hand path", [&](KeyVisitor& visitor) { describe_hand_path(visitor, waypoints); });
}

std::string device_schema() {
  DeviceDesc device;
  return text_of("Fulcrum device", [&](KeyVisitor& visitor) { describe_device_file(visitor, device); });
}

std::string calibration_schema() {
  Calibration calibration;
  return text_of("Fulcrum calibration",
                 [&](KeyVisitor& visitor) { describe_calibration_file(visitor, calibration); });
}

std::string material_schema() {
  ImpactMaterial material;
  return text_of("Fulcrum material", [&](KeyVisitor& visitor) { describe_material_file(visitor, material); });
}

}  // namespace fulcrum::scenario
