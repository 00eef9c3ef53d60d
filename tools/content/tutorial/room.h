#pragma once
// What is only seen: the stand that the panel leans on, the bench below it, and the numbers of the stations.

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

Model make_bench();
Model make_numbers();

}  // namespace fulcrum::content
