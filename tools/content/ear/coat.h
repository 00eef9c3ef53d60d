#pragma once
// Normals and colours of the ear's points: skin, the canal's lining, the drum, and what the cut lays open;
// and how wet they are, but for the drum's, which has a material of its own.

#include <vector>

#include "tools/content/ear/flesh.h"
#include "tools/content/mesh/model.h"

namespace fulcrum::content {

struct MoistCoat {
  Coat coat;
  std::vector<double> wetness;  // of each point, 0 dry to 1 wet
};

// Points in the millimetres of W.
MoistCoat skin_coat(const Flesh& flesh, const Solid& solid);
MoistCoat open_coat(const Flesh& flesh, const Solid& solid);
Coat drum_coat(const Flesh& flesh, const Solid& solid, double rim);

}  // namespace fulcrum::content
