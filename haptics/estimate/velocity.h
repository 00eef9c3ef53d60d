#pragma once
// Velocity of the handle from its sampled pose. An encoder step of 28 um at 1 ms is 28 mm/s: every estimator
// trades that noise for delay, and its delay counts in every stability statement.

#include <vector>

#include "haptics/math/names_of.h"
#include "haptics/math/pose.h"

namespace fulcrum {

enum class VelocityEstimatorKind { difference, low_pass, adaptive_window };
template <>
inline constexpr std::array<std::string_view, 3> names_of<VelocityEstimatorKind>{"difference", "low_pass",
                                                                                 "adaptive_window"};

struct VelocityEstimatorDesc {
  VelocityEstimatorKind kind = VelocityEstimatorKind::low_pass;
  double cutoff_Hz = 60;    // low_pass: first order
  int window = 15;          // adaptive_window: most ticks looked back
  double noise = 60e-6;     // m in W, adaptive_window: largest deviation that counts as noise
  double noise_rad = 4e-4;  // rad, adaptive_window: the same in rotation
};

class VelocityEstimator {
public:
  VelocityEstimator(const VelocityEstimatorDesc& desc, double tick_s);

  // Called once a tick. The first call sets the pose and answers zero.
  Twist update(const Pose& X_WH) noexcept;
  // The same of a caller who says how it came there since the last call: moved (6), m and rad in W.
  Twist update(const Pose& X_WH, const Vec6& moved) noexcept;
  // The pose jumped on purpose (a clutch, a first sample): velocity starts from zero at X_WH.
  void reset(const Pose& X_WH) noexcept;

  double delay() const;  // s, at low frequency; for adaptive_window the longest
  std::size_t bytes() const { return path_.capacity() * sizeof(Vec6); }

private:
  Vec6 difference() const noexcept;
  Vec6 adaptive() const noexcept;

  VelocityEstimatorDesc desc_;
  double tick_s_;
  double keep_;  // low_pass: of the velocity of the tick before
  Pose last_;
  bool started_ = false;
  Vec6 filtered_ = Vec6::Zero();
  // Position, and orientation as the running sum of its small rotations: (window + 1) x (m; rad), newest at
  // head_.
  std::vector<Vec6> path_;
  std::size_t head_ = 0;
  int filled_ = 0;
};

}  // namespace fulcrum
