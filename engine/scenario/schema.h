#pragma once
// JSON Schema (draft 2020-12) of the files that are read here, written from the descriptions that read them:
// for an editor's completion, and for `fulcrum schema`.

#include <string>

namespace fulcrum::scenario {

std::string scenario_schema();     // scenario.yaml
std::string hand_path_schema();    // the file a hand's `path` names
std::string device_schema();       // content/devices/NAME.yaml
std::string calibration_schema();  // calibration/NAME.yaml in a person's configuration
std::string material_schema();     // content/materials/NAME.yaml

}  // namespace fulcrum::scenario
