#include "engine/scenario/device_links.h"

#include "haptics/math/rotation.h"

namespace fulcrum::scenario {

DeviceLinks::DeviceLinks(const MechanismDesc& desc, const MappingDesc& mapping)
    : mapping_(mapping), mechanism_(desc) {
  std::size_t links = 0;
  for (const ArmDesc& arm : desc.arms) {
    joints_.push_back(static_cast<int>(arm.joints.size()));
    links += arm.joints.size();
  }
  X_WL_.resize(links);
}

const std::vector<Pose>& DeviceLinks::follow(const Pose& X_WH) {
  mechanism_.follow(mapping_.handle_in_device(X_WH));
  auto X_WL = X_WL_.begin();
  for (int arm = 0; arm < mechanism_.arms(); ++arm) {
    const JointChain::Placed& placed = mechanism_.placed(arm);
    const JointAngles& angles = mechanism_.angles(arm);
    Quat q_DL = Quat::Identity();
    for (std::size_t j = 0; j < static_cast<std::size_t>(joints_[static_cast<std::size_t>(arm)]); ++j) {
      // About the axis where it is now, and so before the turns that have brought it there.
      q_DL = (quaternion_exp(angles[j] * placed.axis_D[j]) * q_DL).normalized();
      *X_WL++ = mapping_.X_WD * Pose{q_DL, placed.point_D[j]};
    }
  }
  return X_WL_;
}

}  // namespace fulcrum::scenario
