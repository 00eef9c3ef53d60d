#pragma once
// What the finger wears: a ring with a voice coil to either side, their cables, and a cuff.

#include "tools/content/mesh/model.h"
#include "tools/content/sweep/finger_shape.h"

namespace fulcrum::content {

struct RingMaterials {
  std::size_t dark = 0, bright = 0, cloth = 0;
};

// Appends its parts, in mm about the finger.
void add_ring(const FingerShape& shape, const RingMaterials& materials, Model* model);

}  // namespace fulcrum::content
