#pragma once
// A task that is another one for every seed, so that who has learned its places has not learned the task.

#include <cstdint>
#include <vector>

#include "engine/scenario/task.h"

namespace fulcrum::scenario {

struct VariantDesc {
  bool shuffle = false;   // the order in which checkpoints stand
  std::int64_t pick = 0;  // so many of those that are not optional; 0: all
  double spread = 0;      // m, by which each checkpoint may be moved, any way
};

// What the seed makes of the checkpoints: the same everywhere. A checkpoint's line goes with its place. One
// that comes after one that is not picked comes after what that comes after; in the order given the last is
// one that has to be reached, as it is in a file.
void vary(std::vector<Checkpoint>& checkpoints, const VariantDesc& variant, Order order, std::int64_t seed);

}  // namespace fulcrum::scenario
