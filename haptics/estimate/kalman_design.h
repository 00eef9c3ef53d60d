#pragma once
// The steady Kalman filter that estimates position, velocity and acceleration of one axis from its sampled
// position, and what it is worth: lag and noise.
//
// States are counted in ticks and in standard deviations of the measurement: (p, v T, a T^2, j T^3) / noise.
// One number is left of the figures, the index jerk T^(5/2) / noise, and the measurement's variance is 1: the
// filter is as well conditioned at 100 Hz as at 10 kHz. P. R. Kalata, "The tracking index", IEEE Trans.
// Aerospace and Electronic Systems 20(2), 1984.
//
// Three states: jerk is white. Four: jerk is correlated over `jerk_time` (K. Mehrotra, P. R. Mahapatra, "A
// jerk model for tracking highly maneuvering targets", IEEE Trans. Aerospace and Electronic Systems 33(4),
// 1997), of the same density at low frequency.

#include <Eigen/Core>

namespace fulcrum {

using Vec4 = Eigen::Vector4d;
using Mat4 = Eigen::Matrix4d;

struct KalmanModel {
  Mat4 F = Mat4::Zero();    // (4 x 4) of the state, one tick; of three states the last row and column are 0
  Mat4 Q = Mat4::Zero();    // (4 x 4) what a tick adds to its covariance
  Mat4 F_of_constant_jerk;  // (4 x 4) how a motion of constant jerk truly goes on
};

// jerk: m/s^3 per root Hz, noise: m rms, both above 0. jerk_time: s, 0: white. The index is kept within 1e-9
// and 1e6: beyond, the filter looks back for longer than it lives, or no further than it must.
KalmanModel kalman_model(double jerk, double noise, double jerk_time, double tick_s);

struct SteadyFilter {
  Mat4 F;        // (4 x 4) of the model
  Vec4 gain;     // (4) by which the estimate follows the innovation, y less the position that F foretold
  Mat4 P;        // (4 x 4) covariance of the foretold state
  double lag;    // s, of the acceleration at low frequency: its error under unit jerk
  double a_rms;  // in noise / T^2, of the acceleration for white measurement noise
};

// The steady gain, from the algebraic Riccati equation.
SteadyFilter steady_filter(const KalmanModel& model, double tick_s);

}  // namespace fulcrum
