#pragma once
// A body that is seen going to and fro between two places, for a hand to go with. Nothing touches it.

#include <cstdint>

#include "engine/render/visual_desc.h"
#include "haptics/math/linear.h"

namespace fulcrum::scenario {

struct GuideDesc {
  Vec3 from_W = Vec3::Zero();  // (3) m
  Vec3 to_W = Vec3::Zero();    // (3) m
  double speed = 0.2;          // m/s
  double rest = 0;             // s, at either end, and before it sets out from the first
  double radius = 0.004;       // m
};

// (3) m, in W, at a time (s) of the run.
Vec3 guide_place(const GuideDesc& guide, double time);

// Its instance follows kFollowsGuide; its mesh has its middle in the origin.
void add_guide(render::VisualDesc& desc, const GuideDesc& guide, std::uint32_t layers);

}  // namespace fulcrum::scenario
