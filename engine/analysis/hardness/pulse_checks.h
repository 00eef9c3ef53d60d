#pragma once
// What the methods cost and leave missing over random poses and wrenches, and whether `exact` is ever worse
// than another in what it makes small.

#include <vector>

#include "engine/analysis/hardness/strike.h"

namespace fulcrum::analysis::hardness {

// Of one method: what is missing over the cases that are beyond the motors, the time over those within reach.
struct MethodCost {
  PulseMethod method = PulseMethod::exact;
  double missing = 0;                // of the wanted felt wrench, mean
  double median_us = 0, p99_us = 0;  // processor time of a tick's allocation
};

struct PulseChecks {
  std::size_t cases = 0;
  std::size_t clamped = 0;  // cases that are beyond the motors by force alone
  std::size_t beyond = 0;   // cases out of the arms' reach, with the wrenches of the nearest pose; no handle
                            // can be there, and how long the arms are sought there does not count
  // Over the clamped ones, of the wanted wrench's square: what `exact` has more missing than the better of
  // Algorithm 1 and the pseudoinverse, at its worst; below 0: less, always.
  double worst_margin = 0;
  std::size_t better = 0;   // of them, in which it has less missing than either, by 0.1 % and more
  double largest_load = 0;  // of a motor's limit, over all methods and cases
  std::vector<MethodCost> costs;
};

inline constexpr std::size_t kCheckCases = 10000;

// Poses over the workspace and 0.4 rad about each axis, forces of 0.05 to 150 N, grasps up to 0.2 m away.
PulseChecks check_pulses(const DeviceDesc& device, std::size_t cases = kCheckCases);

}  // namespace fulcrum::analysis::hardness
