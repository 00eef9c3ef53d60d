#pragma once

#include "tools/content/ear/flesh.h"
#include "tools/content/mesh/model.h"

namespace fulcrum::content {

// The ear on its piece of the head, and the drum, in metres: whole, and cut open.
Model make_ear(const Flesh& flesh);
Model make_open_ear(const Flesh& flesh);

}  // namespace fulcrum::content
