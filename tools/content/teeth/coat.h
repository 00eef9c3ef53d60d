#pragma once
// Normals and colours of the teeth's and the gum's points.

#include "tools/content/mesh/model.h"
#include "tools/content/teeth/gum.h"

namespace fulcrum::content {

// Points in the millimetres of W.
Coat enamel_coat(const Dentition& dentition, const Gum& gum, std::size_t tooth, const Solid& solid);
Coat gum_coat(const Dentition& dentition, const Gum& gum, const Solid& solid);

}  // namespace fulcrum::content
