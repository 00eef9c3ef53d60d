#pragma once
// How late m a may be before compensating a device's mass makes the hand shake, solved exactly.
//     (m + M) x'' = F - b x' - (k + K_r) x,   F = -K x_j + g m a_j   computed each tick and held
// m the device's mass, M, b, k the hand's, K the wall that the device renders, and a_j what a filter makes of
// the sampled positions, or the true acceleration some whole ticks late. Between ticks the motion of mass,
// damper and hand's spring is exact; the loop grows at ln |z| / T of its largest eigenvalue (linear_loop.h).
//
// To first order in the lag tau, with a = x'' - tau x''': the loop is stable for
//     tau < (M + (1 - g) m) b / (g m (k + K)),   at g = 1  M b / (m k).

#include <vector>

#include "haptics/estimate/acceleration.h"

namespace fulcrum::analysis::uniformity {

struct InertiaLoop {
  double device_mass = 0.25;    // kg, m
  double hand_mass = 0.1;       // kg, M
  double damping = 5;           // N s/m, b, of hand and device
  double hand_stiffness = 300;  // N/m, k
  double wall_stiffness = 0;    // N/m, K
  double gain = 1;              // g
  double tick_s = 1e-3;
};

// 1/s; below 0 the loop is stable. filter: at tick_s.
double growth(const InertiaLoop& loop, const SteadyFilter& filter);
// 1/s, the same for a loop that has the true acceleration of `ticks` ticks ago, 1 and more.
double growth(const InertiaLoop& loop, int ticks);

// s, by the formula above.
double first_order_lag(const InertiaLoop& loop);

// s, of a filter of three states the lag up to which the loop is stable, and what it is at; and the same of a
// true acceleration that is late, in whole ticks. Infinite where no lag is too long.
double largest_filter_lag(const InertiaLoop& loop);
double largest_delay(const InertiaLoop& loop);

}  // namespace fulcrum::analysis::uniformity
