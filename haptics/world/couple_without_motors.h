#pragma once
// A coupling where the response direct would let the tool through.

#include "haptics/world/scene_desc.h"

namespace fulcrum {

// Under the response direct only the device's force keeps the tool out. A device without motors has none, and
// the hand would take the tool through whatever it touches: there the response becomes a constraint, with a
// coupling as stiff as the contact was. A light push then gives the force of direct rendering, and a hard one
// no more than the coupling yields at. Any other scene stays as it is. desc: with its coupling and its
// tool's shell.
void couple_without_motors(SceneDesc& desc);

}  // namespace fulcrum
