#pragma once
// The study of `fulcrum uniformity`: whether a ball feels equally stiff along a whole stick, though the
// device has a mass of its own at one end of it. "Compensating device inertia for 6-DOF haptic rendering",
// III and IV.
//
// A hand strikes the ball with the stick, and slows down by 1 m/s^2 as it goes in; what it feels at a stated
// depth is what the tick commands, less what moves the device's mass:
//     f_h = f_c - m a        tau_h = tau_c + (C - G) x (f_c - m a)
// It is to feel f = K x and h x f, h from G, where it holds, to the contact. The way is given, tremor and
// all, so that a is known; the tick sees it through the device's encoders.

#include <array>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/analysis/uniformity/filter_study.h"
#include "engine/analysis/uniformity/inertia_checks.h"
#include "engine/analysis/uniformity/late_compensation.h"
#include "engine/analysis/uniformity/stick_strike.h"

namespace fulcrum::analysis::uniformity {

// What people tell apart: of stiffness 8 to 22 %, of force 7 to 10 % (15 to 27 % below 0.5 N), of torque 12.7
// %.
inline constexpr double kStiffnessJnd = 0.08, kStiffnessJndHigh = 0.22;
inline constexpr double kTorqueJnd = 0.127;

inline constexpr std::array kStiffnesses{100.0, 200.0, 300.0, 400.0, 500.0, 600.0};  // N/m
inline constexpr std::array kMethods{InertiaMethod::none, InertiaMethod::arm, InertiaMethod::acceleration};

struct UniformityRow {
  InertiaMethod method = InertiaMethod::none;
  double place = 0, stiffness = 0;  // m along the stick from C; N/m, of the ball
  // Over the strikes: means, and standard deviations from strike to strike.
  double felt_stiffness = 0, stiffness_scatter = 0;  // N/m
  double torque_error = 0, torque_scatter = 0;       // N m, about the axis that stick and force span
  double wanted_torque = 0;                          // N m, h x f
  // Of what is felt against the formulas, for the force that the contact gave, largest over the strikes: of
  // the force over the predicted one, of the torque over the predicted one, or kTorqueLeast if that is more.
  double formula_error = 0;
  double depth_error = 0;  // m, of the depth that the contact found, largest over the strikes
  double resistance = 0;   // N, of passivity control, largest over the strikes
  int limited = 0;         // strikes in which the device could not give all
};

struct UniformityStudy {
  std::string command, device;
  double mass = 0, encoder_step = 0;        // kg, m
  double filter_lag = 0, filter_noise = 0;  // s, m/s^2, of the filter that was used
  StrikePath path;
  int strikes = 0;
  std::vector<UniformityRow> rows;  // by method, then stiffness, then place
  std::vector<FilterRow> filters;   // with the device's encoder
  double true_acceleration = 0;     // formula_error of method 2, largest, where it knows the acceleration
  InertiaChecks checks;
  InertiaLoop hand;           // of the limits and of the runs
  std::vector<LateRun> late;  // of it on a ball
};

using UniformityProgress = std::function<void(std::string_view what, double fraction)>;
UniformityStudy study_uniformity(const DeviceDesc& device, const StrikePath& path, int strikes,
                                 const UniformityProgress& progress);

}  // namespace fulcrum::analysis::uniformity
