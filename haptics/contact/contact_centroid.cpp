#include "haptics/contact/contact_centroid.h"

namespace fulcrum {

ContactCentroid contact_centroid(std::span<const ContactRegion> regions, const Pose& X_HW) noexcept {
  Vec3 centre_W = Vec3::Zero(), nhat_W = Vec3::Zero();
  double all = 0, strongest = -1;
  for (const ContactRegion& region : regions) {
    const double force = region.force_W.norm();
    all += force;
    centre_W += force * region.p_W;
    if (force <= strongest) continue;
    strongest = force;
    nhat_W = region.nhat_W;
  }
  if (!(all > 0)) return {};
  return {.any = true, .p_HC = X_HW * Vec3(centre_W / all), .nhat_H = X_HW.q * nhat_W};
}

}  // namespace fulcrum
