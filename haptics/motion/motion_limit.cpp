#include "haptics/motion/motion_limit.h"

#include <algorithm>

namespace fulcrum {
namespace {

constexpr double kLargestAllowance = 0.5e-3;  // m

// A wall thinner than this many allowances could be passed in one tick.
constexpr double kAllowancesPerWall = 8;

}  // namespace

double motion_allowance(const DistanceField& field) {
  const double thinnest = field.thinnest_feature_m();
  return thinnest > 0 ? std::min(kLargestAllowance, thinnest / kAllowancesPerWall) : 0.5 * field.voxel_m();
}

}  // namespace fulcrum
