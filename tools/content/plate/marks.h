#pragma once

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

// The tilt of each plate in degrees, in white on the front of the stand's frame, under its plate. To be seen
// only.
Model make_marks();

}  // namespace fulcrum::content
