#pragma once
// What is said of a device that is there and may not be opened, on whatever bus.

#include <string>

#include "haptics/math/result.h"

namespace fulcrum {

// node: the file in /dev.
Error not_permitted(const std::string& node);

}  // namespace fulcrum
