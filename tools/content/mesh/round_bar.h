#pragma once
// Fine instruments: a round bar whose radius changes along a bent axis, with round ends.

#include <functional>
#include <span>

#include "tools/content/mesh/solid.h"

namespace fulcrum::content {

struct Stretch {
  double length = 0.0;  // m
  double turn = 0.0;    // rad, of the axis on the way, from y towards z
};

// The axis begins at the origin, `heading` (rad) from y towards z. Radius (m) and the step between sections
// (m) are functions of the way along it.
Solid round_bar(std::span<const Stretch> stretches, double heading,
                const std::function<double(double)>& radius, const std::function<double(double)>& step,
                int columns);

}  // namespace fulcrum::content
