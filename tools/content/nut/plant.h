#pragma once

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

// The cover with its bolts, of which one is bare, and the pipes before it.
Model make_cover();

// The wall behind, and what holds the pipes.
Model make_wall();

}  // namespace fulcrum::content
