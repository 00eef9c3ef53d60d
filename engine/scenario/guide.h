#pragma once
// A body that is seen going to and fro between two places, for a hand to go with. Nothing touches it.

#include <cstdint>

#include "engine/render/visual_desc.h"
#include "haptics/math/linear.h"

namespace fulcrum::scenario {

struct GuideDesc {
  Vec3 from_W = Vec3::Zero();  // (3) m
  Vec3 to_W = Vec3::Zero();    // (3) m
  double speed = 0.2;          // m/s, the largest, in the middle: it sets out and stops as a hand does
  double wait = 0;             // s, before it sets out for the first time
  double rest = 0;             // s, at either end
  double radius = 0.004;       // m
};

// (3) m, in W, at a time (s) of the run. Its way has the least jerk, as those of simulated hands have: T.
// Flash and N. Hogan, "The coordination of arm movements" (J. Neuroscience 5(7), 1985).
Vec3 guide_place(const GuideDesc& guide, double time);

// Its instance follows kFollowsGuide; its mesh has its middle in the origin.
void add_guide(render::VisualDesc& desc, const GuideDesc& guide, std::uint32_t layers);

}  // namespace fulcrum::scenario
