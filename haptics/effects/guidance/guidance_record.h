#pragma once
// Guidance, as the trace, the panel, the score and the renderer see it.

#include "haptics/math/pose.h"
#include "haptics/signal/quantity.h"

namespace fulcrum {

// What one tick leaves behind.
struct GuidanceRecord {
  double gain = 0;              // what it is set to; 0: switched off
  double level = 0;             // that is there of it, after its ramp
  double time = 0;              // s of the expert's way without its rests: how far along it the handle is
  double distance = 0;          // m, of the handle from there; 0 while it is off
  Vec3 force_D = Vec3::Zero();  // (3) N on the handle, before safety
  Pose X_WT_ahead;              // of the expert's tool, a little further on
};

template <class V>
void describe(V& values, const GuidanceRecord& record) {
  const auto& [gain, level, time, distance, force_D, X_WT_ahead] = record;
  values.number({"guidance/gain", "1", "", "What guidance is set to; 0: off."}, gain);
  values.number({"guidance/level", "1", "", "That is there of it, after its ramp."}, level);
  values.number({"guidance/time", "s", "",
                 "Of the expert's way without its rests: how far along it the handle has come."},
                time);
  values.number({"guidance/distance", "m", "", "Of the handle from there; 0 while guidance is off."},
                distance);
  values.vector({"guidance/force", "N", "D", "Of guidance on the handle, before safety."}, force_D);
  values.unseen(X_WT_ahead.q.w());  // it follows from the time and the expert's way
  values.unseen(Vec3(X_WT_ahead.q.vec()));
  values.unseen(X_WT_ahead.p);
}

}  // namespace fulcrum
