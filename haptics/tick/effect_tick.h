#pragma once
// What a tick knows so far. step() fills it from top to bottom; an effect that is asked at one stage reads
// what stands above that stage's line and nothing below.

#include <cstdint>
#include <span>

#include "haptics/contact/contact_centroid.h"
#include "haptics/contact/impact.h"
#include "haptics/contact/regions.h"
#include "haptics/tick/handle_motion.h"
#include "haptics/tick/tool_answer.h"

namespace fulcrum {

struct EffectTick {
  std::int64_t tick = 0;
  HandleMotion handle;

  ToolAnswer answer;
  Vec3 p_WH = Vec3::Zero();  // (3) m, the handle's place on the tool, not the hand's: handle.X_WH
  std::span<const ContactRegion> regions;  // that touch
  std::span<const Impact> impacts;         // of this tick, where an effect of the scene asks for them
  ContactCentroid touched;                 // where the scene names a holding point

  bool stopped = false;          // safety holds the force back until it is acknowledged
  double gain = 0;               // of ramp and stop, at the last command: 0 to 1
  Vec3 wished_D = Vec3::Zero();  // (3) N on the handle, of the coupling, whether the device can push or not
  // Effect::shape()
  Wrench wanted_F_H_D;  // continuous, on the handle about H
  // Effect::correct()
  Vec3 felt_D = Vec3::Zero();  // (3) N, of that what the guard lets through
  // Effect::strike(), settle(), command()
};

}  // namespace fulcrum
