#include "engine/analysis/uniformity/uniformity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "haptics/bake/parallel.h"
#include "haptics/math/functions.h"
#include "haptics/world/world.h"

namespace fulcrum::analysis::uniformity {
namespace {

constexpr int kPlaces = 11;  // along the stick
// So long that what the filter saw of its beginning has faded beyond rounding.
constexpr StrikePath kEvenStrike{.acceleration = 0.5, .travel = 0.18, .tremor = 0};
constexpr std::array kLateJerks{30.0, 5.0, 0.2};  // m/s^3 per root Hz: in time, near the limit, late

double place_of(int i) {  // m
  return i * kStickLength / (kPlaces - 1);
}

struct Moments {
  double mean = 0, deviation = 0;
};

Moments moments_of(const std::vector<double>& values) {
  Moments m;
  const auto n = static_cast<double>(values.size());
  for (const double v : values) m.mean += v / n;
  for (const double v : values) m.deviation += math::square(v - m.mean) / std::max(1.0, n - 1);
  m.deviation = std::sqrt(m.deviation);
  return m;
}

InertiaCompensationDesc compensation_by(InertiaMethod method) {
  InertiaCompensationDesc by;
  by.method = method;
  by.switchable = false;
  return by;
}

void strike_often(UniformityRow& row, const StickBodies& bodies, const DeviceDesc& device,
                  const StrikePath& path, int strikes) {
  const StickTouch touch{row.place, path.held, row.stiffness};
  const SceneDesc scene = stick_scene(bodies, device, touch, compensation_by(row.method));
  std::vector<double> stiffnesses, torques;
  for (int s = 0; s < strikes; ++s) {
    const StrikeOutcome felt =
        strike(std::move(*World::build(scene)), touch, path, row.method, static_cast<std::uint64_t>(s) + 1);
    const double wanted = (touch.place - touch.held) * touch.stiffness * felt.depth;
    stiffnesses.push_back(felt.force / felt.depth);
    torques.push_back(felt.torque - wanted);
    row.wanted_torque += wanted / strikes;
    row.formula_error = std::max({row.formula_error, felt.force_off, felt.torque_off});
    row.depth_error = std::max(row.depth_error, felt.depth_error);
    row.resistance = std::max(row.resistance, std::abs(felt.resistance));
    row.limited += felt.limited ? 1 : 0;
  }
  const Moments k = moments_of(stiffnesses), torque = moments_of(torques);
  row.felt_stiffness = k.mean;
  row.stiffness_scatter = k.deviation;
  row.torque_error = torque.mean;
  row.torque_scatter = torque.deviation;
}

// The largest error of method 2 where its filter sees the acceleration exactly: it is even, and the encoder
// has no steps.
double with_true_acceleration(const StickBodies& bodies, DeviceDesc device, double held) {
  device.encoder_step = 0;
  InertiaCompensationDesc by = compensation_by(InertiaMethod::acceleration);
  by.encoder_noise = by.filter.noise;
  double worst = 0;
  for (const double stiffness : kStiffnesses) {
    for (int i = 0; i < kPlaces; ++i) {
      const StickTouch touch{place_of(i), held, stiffness};
      const StrikeOutcome felt = strike(std::move(*World::build(stick_scene(bodies, device, touch, by))),
                                        touch, kEvenStrike, by.method, 1);
      worst = std::max({worst, felt.force_off, felt.torque_off});
    }
  }
  return worst;
}

}  // namespace

UniformityStudy study_uniformity(const DeviceDesc& device, const StrikePath& path, int strikes,
                                 const UniformityProgress& progress) {
  UniformityStudy study;
  study.device = device.name;
  study.mass = device.handle_mass;
  study.encoder_step = device.encoder_step;
  study.path = path;
  study.strikes = strikes;
  study.hand.device_mass = device.handle_mass;
  study.hand.wall_stiffness = 300;
  AccelerationEstimatorDesc used;
  used.noise = device.encoder_step / std::sqrt(12.0);
  const AccelerationEstimator filter(used, study.hand.tick_s);
  study.filter_lag = filter.lag();
  study.filter_noise = filter.noise();
  progress("filters", 0);
  study.filters = study_filters(device.encoder_step, study.hand.tick_s);
  study.checks = check_inertia(device);
  const StickBodies bodies = stick_bodies();
  study.true_acceleration = with_true_acceleration(bodies, device, path.held);
  study.late = study_late_compensation(bodies, device, study.hand, {kLateJerks.begin(), kLateJerks.end()});
  for (const InertiaMethod method : kMethods) {
    for (const double stiffness : kStiffnesses)
      for (int i = 0; i < kPlaces; ++i)
        study.rows.push_back({.method = method, .place = place_of(i), .stiffness = stiffness});
  }
  for_each_piece(
      study.rows.size(), 0,
      [&](std::size_t i) { strike_often(study.rows[i], bodies, device, path, strikes); },
      [&progress](double fraction) { progress("strikes", fraction); });
  return study;
}

}  // namespace fulcrum::analysis::uniformity
