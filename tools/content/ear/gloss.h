#pragma once
// How wet the ear is, from dry skin to the lining of the canal: one picture of roughness, which is laid along
// the wetness of each point.

#include <string>
#include <vector>

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

// Its colours are those of the points.
Material moist(const std::string& name);

// wetness: of each of the solid's points, 0 dry to 1 wet.
CornerUv laid_by_wetness(const Solid& solid, const std::vector<double>& wetness);

}  // namespace fulcrum::content
