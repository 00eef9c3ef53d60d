#include "haptics/world/couple_without_motors.h"

#include <algorithm>

namespace fulcrum {
namespace {

// Of the stiffness at the tool's farthest point: by how much less the tool gives way by turning than by
// moving. Under the response direct it does not turn at all.
constexpr double kAngularShare = 10;

}  // namespace

void couple_without_motors(SceneDesc& desc) {
  if (coupled(desc.contact.response) || desc.device.renders_force) return;
  desc.contact.response = ContactResponse::constraint;
  desc.contact.levels.clear();
  desc.coupling.stiffness = desc.contact.stiffness;
  const double reach = tool_radius(desc);
  desc.coupling.angular_stiffness =
      std::max(desc.coupling.angular_stiffness, kAngularShare * desc.contact.stiffness * reach * reach);
}

}  // namespace fulcrum
