#pragma once
// Where the links of a device's arms are in the scene, for the models that follow them.

#include <vector>

#include "haptics/actuation/mechanism.h"
#include "haptics/device/mapping.h"

namespace fulcrum::scenario {

class DeviceLinks {
public:
  // A table that Mechanism::refuse() has passed; mapping of position_scale 1.
  DeviceLinks(const MechanismDesc& desc, const MappingDesc& mapping);

  // X_WL of each link, arm by arm, base to end. L has its origin on the joint that turns the link, and D's
  // axes where all angles are 0.
  const std::vector<Pose>& follow(const Pose& X_WH);

private:
  MappingDesc mapping_;
  Mechanism mechanism_;
  std::vector<int> joints_;  // of each arm
  std::vector<Pose> X_WL_;
};

}  // namespace fulcrum::scenario
