#pragma once

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

// What the boards stand on: to be seen, not touched.
Model make_bench();

}  // namespace fulcrum::content
