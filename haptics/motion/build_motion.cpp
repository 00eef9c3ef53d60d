#include "haptics/motion/build_motion.h"

#include "haptics/motion/constrained_motion.h"
#include "haptics/motion/direct_motion.h"
#include "haptics/motion/dynamic_motion.h"
#include "haptics/motion/feature_motion.h"
#include "haptics/motion/quasi_static_motion.h"

namespace fulcrum {

std::unique_ptr<ToolMotion> build_motion(const PlainScene& desc) {
  switch (desc.contact.response) {
    case ContactResponse::penalty:
    case ContactResponse::voxel:
      break;
    case ContactResponse::quasi_static:
      return std::make_unique<QuasiStaticMotion>(desc);
    case ContactResponse::constraint:
      if (desc.tool_features) return std::make_unique<FeatureMotion>(desc);
      return std::make_unique<ConstrainedMotion>(desc);
    case ContactResponse::direct:
      return std::make_unique<DirectMotion>(desc);
  }
  return std::make_unique<DynamicMotion>(desc);
}

}  // namespace fulcrum
