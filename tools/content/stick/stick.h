#pragma once
// The stick, along +x from the stage that carries it: the device's last part, where its motors push.

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

inline constexpr double stick_radius = 4.0 * mm;
inline constexpr double stick_length = 200.0 * mm;
inline constexpr double strip_from = 30.0 * mm;  // the strip that senses where the hand presses
inline constexpr double strip_to = 170.0 * mm;

// The origin is the stage's centre.
Model make_stick();

}  // namespace fulcrum::content
