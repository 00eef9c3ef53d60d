#pragma once
// Wood, as the rings of a log are seen where it is cut.

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

struct Wood {
  Eigen::Vector3d early;  // linear colour of what grew in spring
  Eigen::Vector3d late;   // of what grew in autumn
  double ring = 4.0;      // mm, from ring to ring
  Eigen::Vector2d pith;   // mm, where the log's middle runs along z
};

inline const Wood beech{{0.62, 0.42, 0.25}, {0.44, 0.27, 0.14}, 3.2, {23.0, 31.0}};
inline const Wood oak{{0.40, 0.25, 0.13}, {0.22, 0.125, 0.06}, 5.0, {14.0, -95.0}};
inline const Wood walnut{{0.165, 0.085, 0.042}, {0.065, 0.032, 0.016}, 4.0, {9.0, 14.0}};

// Linear, at a place in the log (mm), whose grain runs along z.
Eigen::Vector3d wood_colour(const Eigen::Vector3d& p, const Wood& wood);

// The coat of a solid whose grain runs along z.
Coat grained(const Solid& solid, const Wood& wood);

}  // namespace fulcrum::content
