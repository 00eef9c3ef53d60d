#pragma once

#include "tools/content/mesh/model.h"
#include "tools/content/teeth/gum.h"

namespace fulcrum::content {

// The gum and the teeth as solids, in metres. The models' order: "tooth/47" to "tooth/37", then "gum".
Model make_jaw(const Dentition& dentition);

}  // namespace fulcrum::content
