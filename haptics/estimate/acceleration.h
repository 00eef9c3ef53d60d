#pragma once
// Acceleration of a point from its sampled position, by a Kalman filter on each axis. A device without an
// accelerometer has no other; what it costs is lag, which counts in every stability statement, and noise.
//
// The default `jerk` is chosen for an encoder of 10 um at 1 kHz: 4.8 ms of lag and 0.15 m/s^2 of noise.
// Compensating 250 g then scatters by 0.04 N, a tenth of the 0.4 N of a ball of 100 N/m pressed in by 4 mm
// and below what a finger tells apart there; half the noise would cost half as much lag again, which a light
// hand does not bear. With `jerk` lag falls as jerk^(-1/3) and noise grows as jerk^(5/6), until lag is a few
// ticks.

#include "haptics/estimate/kalman_design.h"
#include "haptics/math/linear.h"
#include "haptics/math/names_of.h"

namespace fulcrum {

enum class AccelerationEstimatorKind {
  kalman,   // three states, white jerk: a steady gain
  adaptive  // four states, jerk correlated in time; how much of it is expected follows the innovations
};
template <>
inline constexpr std::array<std::string_view, 2> names_of<AccelerationEstimatorKind>{"kalman", "adaptive"};

struct AccelerationEstimatorDesc {
  AccelerationEstimatorKind kind = AccelerationEstimatorKind::kalman;
  double jerk = 5;           // m/s^3 per root Hz, density of the jerk that is expected, at low frequency
  double noise = 2.9e-6;     // m rms, of the measured position: of an encoder its step / sqrt(12)
  double jerk_time = 0.02;   // s, adaptive: over which jerk is correlated
  double adapt_time = 0.02;  // s, adaptive: over which innovations are judged
  double range = 30;         // adaptive: how many times more or less jerk than `jerk` may be expected
};

class AccelerationEstimator {
public:
  AccelerationEstimator(const AccelerationEstimatorDesc& desc, double tick_s);

  // Starts from rest at p (3) m.
  void reset(const Vec3& p) noexcept;
  // Called once a tick: p (3) m, as measured. The first call, and the first after a position that is not
  // finite, starts from rest. Answers the acceleration, (3) m/s^2.
  Vec3 update(const Vec3& p) noexcept;

  // Instead of update(), in a tick that comes late, with others, at one position of the handle: the filter
  // takes the place and keeps its velocity and acceleration. A way of many ticks in one would be a blow.
  Vec3 catch_up(const Vec3& p) noexcept;

  Vec3 velocity() const;      // (3) m/s
  Vec3 acceleration() const;  // (3) m/s^2

  // Of the steady gain; of adaptive at the jerk it was given.
  double lag() const { return steady_.lag; }  // s, at low frequency
  double noise() const;                       // m/s^2 rms, for white measurement noise of desc.noise
  const SteadyFilter& steady() const { return steady_; }

private:
  struct Adaptation {
    Mat4 P;           // (4 x 4) covariance of the estimate
    double more = 1;  // times the process noise of the model
  };
  Vec4 adapted_gain(Adaptation& axis, double predicted, double seen) const noexcept;

  AccelerationEstimatorDesc desc_;
  double tick_s_;
  KalmanModel model_;
  SteadyFilter steady_;
  bool started_ = false;
  Vec3 origin_ = Vec3::Zero();  // (3) m, where it started
  Eigen::Matrix<double, 4, 3> state_ =
      Eigen::Matrix<double, 4, 3>::Zero();  // of each axis, in the model's units
  Adaptation adaptation_[3];
};

}  // namespace fulcrum
