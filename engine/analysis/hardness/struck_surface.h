#pragma once
// A surface struck by a simulated device in a hand: the force that its motors are told, tick by tick.

#include <vector>

#include "engine/analysis/hardness/strike.h"

namespace fulcrum::analysis::hardness {

// N, along the normal, from the tick in which the handle meets the surface until it turns back, at most
// kStruckTicks of them: the pulse in the first, the spring in all. The handle has the hand's mass and the
// device's, with its damping and friction; positions are exact, since encoder counts would add up to k step /
// (T v0) to the slope of a spring.
inline constexpr int kStruckTicks = 40;
std::vector<double> struck_forces(const DeviceDesc& device, const StrikeSetting& setting, double pulse);

// (max dF/dt) / v0, N/m, between ticks: G. Han, S. Choi, "Extended rate-hardness", EuroHaptics 2010. Before
// the first there was no force.
double extended_rate_hardness(const std::vector<double>& forces, const StrikeSetting& setting);

}  // namespace fulcrum::analysis::hardness
