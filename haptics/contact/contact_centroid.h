#pragma once
// One place that stands for all contact on a tool.

#include <span>

#include "haptics/contact/regions.h"
#include "haptics/math/pose.h"

namespace fulcrum {

// p_HC is the mean of the regions' places, weighed by their forces; nhat_H is the normal of the region that
// presses most.
struct ContactCentroid {
  bool any = false;            // something presses on the tool
  Vec3 p_HC = Vec3::Zero();    // (3) m, in H
  Vec3 nhat_H = Vec3::Zero();  // (3) unit, towards the tool
};

// X_HW: the scene in the handle, where the tool holds the handle.
ContactCentroid contact_centroid(std::span<const ContactRegion> regions, const Pose& X_HW) noexcept;

}  // namespace fulcrum
