#pragma once
// A texture, as the trace, the panel and the digest see it.

#include "haptics/math/linear.h"
#include "haptics/signal/quantity.h"

namespace fulcrum {

// What one tick leaves behind.
struct TextureRecord {
  double gain = 0;              // of the slopes; 0: switched off
  double fade = 1;              // 1: the ridges are felt whole; 0: they pass too fast for the tick
  Vec3 force_W = Vec3::Zero();  // (3) N on the handle, of all regions, before safety
};

template <class V>
void describe(V& values, const TextureRecord& record) {
  const auto& [gain, fade, force_W] = record;
  values.number({"texture/gain", "1", "", "What the texture is set to; 0: off."}, gain);
  values.number({"texture/fade", "1", "", "1 while its ridges are felt whole; 0: they pass too fast."}, fade);
  values.vector({"texture/force", "N", "W", "Of the ridges on the handle, before safety."}, force_W);
}

}  // namespace fulcrum
