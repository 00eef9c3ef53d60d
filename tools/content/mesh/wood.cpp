#include "tools/content/mesh/wood.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/functions.h"
#include "tools/content/mesh/paint.h"
#include "tools/content/mesh/smooth.h"

namespace fulcrum::content {

using Eigen::Vector3d;

// A ring begins light, grows darker and ends at once. Trunks are not quite round and not quite straight, and
// no two years are alike.
Vector3d wood_colour(const Vector3d& p, const Wood& wood) {
  const Vector3d slow(0.05 * p.x(), 0.05 * p.y(), 0.011 * p.z());
  const Vector3d quick(0.16 * p.x(), 0.16 * p.y(), 0.035 * p.z());
  const double r =
      math::hypot(p.x() - wood.pith.x(), p.y() - wood.pith.y()) + 3.4 * mottle(slow) + 0.5 * mottle(quick);
  const double years = r / wood.ring + 0.7 * mottle(Vector3d(0.055 * r, 3.3, 1.7));
  const double year = std::floor(years);
  const double t = years - year;
  const double late = smooth_step(0.2, 0.9, t) * (1.0 - smooth_step(0.9, 1.0, t));
  const double dark = 0.5 + 0.25 * mottle(Vector3d(1.9 * year, 0.7 * year, 5.1));
  const double fibre = mottle(Vector3d(2.9 * p.x(), 3.1 * p.y(), 0.09 * p.z()));
  return mixed(wood.early, wood.late, std::clamp(dark * late + 0.14 * fibre + 0.14, 0.0, 1.0));
}

Coat grained(const Solid& solid, const Wood& wood) {
  Coat coat;
  for (const Vector3d& p : solid.points) coat.colours.push_back(wood_colour(p / mm, wood));
  return coat;
}

}  // namespace fulcrum::content
