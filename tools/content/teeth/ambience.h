#pragma once
// What surrounds a point of a tooth or of the gum, for the light that reaches it (mesh/paint.h).

#include <algorithm>
#include <vector>

#include "tools/content/teeth/gum.h"

namespace fulcrum::content {

inline const std::vector<double> surroundings{0.25, 0.6, 1.3, 2.6};  // mm, how far openness() looks

// mm, to a tooth and its neighbours.
inline double teeth_distance(const Dentition& dentition, std::size_t around, const Eigen::Vector3d& p) {
  double least = 1e3;
  const std::size_t last = dentition.teeth.size() - 1;
  for (std::size_t i = around == 0 ? 0 : around - 1; i <= std::min(around + 1, last); ++i)
    least = std::min(least, dentition.teeth[i].distance(p));
  return least;
}

}  // namespace fulcrum::content
