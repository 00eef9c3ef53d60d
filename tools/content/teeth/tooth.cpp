#include "tools/content/teeth/tooth.h"

#include "tools/content/mesh/smooth.h"

namespace fulcrum::content {

double ToothDesign::distance(const Eigen::Vector3d& p) const {
  const double sides = body.distance(p);
  // The top's slope is about 0.6 on the whole: its vertical distance is that much too long.
  const double top = 0.85 * (p.z() - relief.height(p.x(), p.y()));
  const double crown = smooth_max(sides, top, edge);
  return smooth_max(crown, body.low - p.z(), 0.6);
}

}  // namespace fulcrum::content
