#include "engine/headset/rigid_fit.h"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "haptics/math/number_text.h"

namespace fulcrum::headset {
namespace {

// As a pair: the same mean in both frames.
PointPair mean_of(std::span<const PointPair> pairs) {
  PointPair mean;
  for (const PointPair& pair : pairs) {
    mean.p_D += pair.p_D;
    mean.p_L += pair.p_L;
  }
  const auto n = static_cast<double>(pairs.size());
  return {mean.p_D / n, mean.p_L / n};
}

// m, RMS, of the points from the line that fits them best, in the one frame or the other.
double aside_of(std::span<const PointPair> pairs, Vec3 PointPair::*point) {
  const Vec3 mean = mean_of(pairs).*point;
  Mat3 spread = Mat3::Zero();
  for (const PointPair& pair : pairs) spread += (pair.*point - mean) * (pair.*point - mean).transpose();
  const Eigen::SelfAdjointEigenSolver<Mat3> principal(spread / static_cast<double>(pairs.size()),
                                                      Eigen::EigenvaluesOnly);
  const Vec3& variance = principal.eigenvalues();  // ascending
  return std::sqrt(std::max(0.0, variance[0] + variance[1]));
}

std::string mm(double m) {
  return number_text(std::round(1e4 * m) / 10) + " mm";
}

std::optional<Error> refuse(std::span<const PointPair> pairs) {
  if (pairs.size() < kFewestPoints)
    return Error{"Three points are needed at least, and there are " + std::to_string(pairs.size()) +
                 ": touch more of them."};
  for (const PointPair& pair : pairs)
    if (!pair.p_D.allFinite() || !pair.p_L.allFinite())
      return Error{"A point has no place: touch it again, where the headset sees the controller."};
  for (std::size_t i = 0; i < pairs.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      if (const double apart = (pairs[i].p_D - pairs[j].p_D).norm(); apart < kNearestPoints)
        return Error{"Points " + std::to_string(j + 1) + " and " + std::to_string(i + 1) + " are " +
                     mm(apart) + " apart: touch places that are " + mm(kNearestPoints) +
                     " apart at least, and better as far as the handle reaches."};
  if (const double aside = aside_of(pairs, &PointPair::p_D); aside < kLeastAside)
    return Error{"The points lie nearly in a line, " + mm(aside) +
                 " beside it: touch one well to the side of the others."};
  if (aside_of(pairs, &PointPair::p_L) < kLeastAside / 2)
    return Error{
        "The controller was at one place, or in a line, while the handle was not: hold its tip at the "
        "handle's "
        "point each time."};
  return std::nullopt;
}

}  // namespace

Result<RigidFit> fit_rigid(std::span<const PointPair> pairs) {
  if (auto refused = refuse(pairs)) return *refused;
  const PointPair mean = mean_of(pairs);
  Mat3 across = Mat3::Zero();
  for (const PointPair& pair : pairs) across += (pair.p_L - mean.p_L) * (pair.p_D - mean.p_D).transpose();
  const Eigen::JacobiSVD<Mat3> svd(across, Eigen::ComputeFullU | Eigen::ComputeFullV);
  // The direction in which the points say least takes the sign that makes a rotation of it.
  Vec3 signs = Vec3::Ones();
  if ((svd.matrixU() * svd.matrixV().transpose()).determinant() < 0) signs.z() = -1;
  RigidFit fit;
  const Mat3 turn_LD = svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose();
  fit.X_LD.q = Quat(turn_LD).normalized();
  fit.X_LD.p = mean.p_L - fit.X_LD.q * mean.p_D;
  double squares = 0;
  for (const PointPair& pair : pairs) {
    fit.residuals.push_back((pair.p_L - fit.X_LD * pair.p_D).norm());
    squares += fit.residuals.back() * fit.residuals.back();
  }
  fit.rms = std::sqrt(squares / static_cast<double>(pairs.size()));
  return fit;
}

}  // namespace fulcrum::headset
