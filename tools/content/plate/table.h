#pragma once

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

// The optical table that the stand is on: to be seen, not touched.
Model make_table();

}  // namespace fulcrum::content
