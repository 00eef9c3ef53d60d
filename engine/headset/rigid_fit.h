#pragma once
// The rigid transform that lays points of a device's base onto the same points in a headset's space.
//
// The least squares rotation is found by a singular value decomposition (W. Kabsch, "A solution for the best
// rotation to relate two sets of vectors", Acta Crystallographica A32, 1976), and never is a mirror image
// (S. Umeyama, "Least-squares estimation of transformation parameters between two point patterns", IEEE
// Transactions on Pattern Analysis and Machine Intelligence 13(4), 1991).

#include <span>
#include <vector>

#include "haptics/math/pose.h"
#include "haptics/math/result.h"

namespace fulcrum::headset {

// One place, touched with the device's handle and with a controller.
struct PointPair {
  Vec3 p_D = Vec3::Zero();  // (3) m, in the device's base
  Vec3 p_L = Vec3::Zero();  // (3) m, in the headset's space
};

struct RigidFit {
  Pose X_LD;                      // the device's base in the headset's space
  std::vector<double> residuals;  // (n) m, |p_L - X_LD p_D| of each pair
  double rms = 0;                 // m, of these
};

inline constexpr std::size_t kFewestPoints = 3;
inline constexpr double kNearestPoints = 0.03;  // m, from each other: what lies closer gives no direction
inline constexpr double kLeastAside = 0.01;     // m, RMS distance from the line that fits the points best

// Errors: what is wrong with the points, and what to do about it: too few, not finite, too near each other,
// or nearly in a line, in either frame. Three points lie in a plane, and fit their mirror image as well as
// themselves; of four that do not, a mirror image shows in the residual.
Result<RigidFit> fit_rigid(std::span<const PointPair> pairs);

}  // namespace fulcrum::headset
