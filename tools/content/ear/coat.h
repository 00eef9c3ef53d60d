#pragma once
// Normals and colours of the ear's points: skin, the canal's lining, the drum, and what the cut lays open.

#include "tools/content/ear/flesh.h"
#include "tools/content/mesh/model.h"

namespace fulcrum::content {

// Points in the millimetres of W.
Coat skin_coat(const Flesh& flesh, const Solid& solid);
Coat open_coat(const Flesh& flesh, const Solid& solid);
Coat drum_coat(const Flesh& flesh, const Solid& solid, double rim);

}  // namespace fulcrum::content
