#pragma once
// A Falcon's firmware is its maker's, and does not come with Fulcrum: a file that the person brings.

#include <cstdint>
#include <vector>

#include "haptics/math/result.h"

namespace fulcrum::falcon {

// From the file that FULCRUM_FALCON_FIRMWARE names, or falcon_firmware.bin in $XDG_CONFIG_HOME/fulcrum, else
// ~/.config/fulcrum. Errors: there is none, and where it comes from and goes to; or it cannot be the
// firmware.
Result<std::vector<std::uint8_t>> find_firmware();

}  // namespace fulcrum::falcon
