#pragma once
// What each acceleration filter costs and how far from the true acceleration it is: lag, noise, error against
// run time.

#include <string_view>
#include <vector>

#include "haptics/estimate/acceleration.h"

namespace fulcrum::analysis::uniformity {

struct FilterRow {
  AccelerationEstimatorKind kind = AccelerationEstimatorKind::kalman;
  double jerk = 0;            // m/s^3 per root Hz, as set
  double lag = 0, noise = 0;  // s, m/s^2 rms: as the filter states them
  double measured_lag = 0,
         measured_noise = 0;  // against an exact motion of 1 Hz; of an encoder's counts on it
  double error = 0;           // m/s^2 rms, against a hand's motion with tremor, through the encoder
  double cpu_ns = 0;          // of an update of three axes
};

// encoder_step: m, above 0.
std::vector<FilterRow> study_filters(double encoder_step, double tick_s);

}  // namespace fulcrum::analysis::uniformity
