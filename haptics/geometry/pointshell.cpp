#include "haptics/geometry/pointshell.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "haptics/geometry/kd_order.h"

namespace fulcrum {

Result<Pointshell> pointshell_from_points(std::span<const Vec3> positions, std::span<const Vec3> normals,
                                          std::span<const double> areas_m2, double covering_radius_m) {
  if (positions.empty())
    return Error{"A pointshell needs at least one point: give the tool's contact points."};
  if (normals.size() != positions.size() || areas_m2.size() != positions.size()) {
    return Error{"A pointshell of " + std::to_string(positions.size()) + " points came with " +
                 std::to_string(normals.size()) + " normals and " + std::to_string(areas_m2.size()) +
                 " areas: give one of each per point."};
  }
  if (!(covering_radius_m >= 0.0) || !std::isfinite(covering_radius_m))
    return Error{"A pointshell's covering radius must be zero or a positive length in metres."};
  for (std::size_t i = 0; i < positions.size(); ++i) {
    const bool good = positions[i].allFinite() && normals[i].allFinite() && normals[i].norm() > 0.0 &&
                      std::isfinite(areas_m2[i]) && areas_m2[i] >= 0.0;
    if (!good) {
      return Error{
          "Point " + std::to_string(i) +
          " of a pointshell needs a finite position, a normal that is not zero and an area that is not "
          "negative: correct it."};
    }
  }
  Pointshell shell;
  for (const std::uint32_t i : kd_order(positions)) {
    shell.positions.push_back(positions[i]);
    shell.normals.push_back(normals[i].normalized());
    shell.areas_m2.push_back(areas_m2[i]);
    shell.max_radius_m = std::max(shell.max_radius_m, positions[i].norm());
  }
  shell.covering_radius_m = covering_radius_m;
  return shell;
}

Pointshell transformed(const Pointshell& shell_M, const Pose& X_TM) {
  Pointshell shell = shell_M;
  shell.max_radius_m = 0.0;
  for (Vec3& p : shell.positions) {
    p = X_TM * p;
    shell.max_radius_m = std::max(shell.max_radius_m, p.norm());
  }
  for (Vec3& n : shell.normals) n = X_TM.q * n;
  return shell;
}

}  // namespace fulcrum
