#include "engine/analysis/uniformity.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

#include "haptics/bake/parallel.h"
#include "haptics/device/hand.h"
#include "haptics/math/split_mix.h"
#include "haptics/safety/faults.h"
#include "haptics/world/world.h"

namespace fulcrum::analysis {
namespace {

// Ticks at rest, by which force, and after it compensation, have come in.
constexpr int kForceIn = 510, kCompensationIn = 1020;
constexpr int kPlaces = 11;                       // along the stick
constexpr std::array kLateJerks{30.0, 5.0, 0.2};  // m/s^3 per root Hz: in time, near the limit, late
constexpr double kDifference = 1e-4;              // s, of tremor's acceleration

// Where the handle is, from where the stick just touches, and how it accelerates.
class HandleWay {
public:
  HandleWay(const StrikePath& path, double rest, std::uint64_t seed)
      : path_(path), rest_(rest), tremor_(shaking(path, seed)) {}

  Vec3 p(double t) const {
    const double half = std::sqrt(path_.travel / path_.acceleration), a = path_.acceleration;
    const double top = path_.travel - path_.depth - path_.beyond, s = std::max(0.0, t - rest_);
    const double y =
        s < half ? top - 0.5 * a * s * s : top - path_.travel + 0.5 * a * std::pow(2 * half - s, 2);
    return Vec3(0, y, 0) + shake(t);
  }
  // While it slows down.
  Vec3 a(double t) const {
    const Vec3 second = shake(t + kDifference) - 2 * shake(t) + shake(t - kDifference);
    return Vec3(0, path_.acceleration, 0) + second / (kDifference * kDifference);
  }

private:
  static HandDesc shaking(const StrikePath& path, std::uint64_t seed) {
    HandDesc hand;
    hand.tremor = path.tremor;
    hand.seed = seed;
    return hand;
  }
  Vec3 shake(double t) const { return tremor_.at(t).head<3>(); }

  StrikePath path_;
  double rest_;
  Tremor tremor_;
};

struct Felt {
  double depth = 0, force = 0, torque = 0;  // m; N, up; N m, about z at G
  double formula_error = 0;
  bool limited = false;
};

// By the formulas, at G: what the method is to make of a contact force f at `l` from C.
Wrench by_formula(InertiaMethod method, const StickTouch& touch, const Vec3& f, const Vec3& inertia) {
  const Vec3 l(touch.place, -kStickRadius, 0), g(touch.held, 0, 0), h = l - g;
  Wrench felt{f - inertia, h.cross(f) + g.cross(inertia)};
  const bool between = touch.place <= touch.held;
  if (method == InertiaMethod::arm && between) felt.torque -= g.cross(f);
  return method == InertiaMethod::acceleration ? Wrench{f, h.cross(f)} : felt;
}

Felt strike(World world, const StickTouch& touch, const StrikePath& path, InertiaMethod method,
            std::uint64_t seed) {
  const SceneDesc& scene = world.desc();
  const double T = scene.tick_s, step_m = scene.device.encoder_step;
  const int rest = method == InertiaMethod::acceleration ? kCompensationIn : kForceIn;
  const HandleWay way(path, rest * T, seed);
  SplitMix random(seed);
  const double phase = random.uniform();  // of the encoders' counts
  for (std::int64_t k = 0;; ++k) {
    const double t = static_cast<double>(k) * T;
    const Vec3 p = way.p(t);
    DeviceSample sample;
    sample.X_DH.p = step_m > 0 ? Vec3(((p / step_m).array() + phase).round() - phase) * step_m : p;
    const StepResult result = step(world, sample, {});
    if (k < rest || -p.y() < path.depth) continue;
    Wrench F_H_D = result.command.F_H_D;
    F_H_D.force.y() -= scene.device.handle_weight;
    // It is held until the next tick: what it is to be is that of half way.
    const double depth = -way.p(t + 0.5 * T).y();
    const Vec3 inertia = scene.device.handle_mass * way.a(t + 0.5 * T), g(touch.held, 0, 0);
    const Vec3 f_h = F_H_D.force - inertia, tau_h = F_H_D.torque - g.cross(f_h);
    const Vec3 f(0, touch.stiffness * depth, 0);
    const Wrench formula = by_formula(method, touch, f, inertia);
    const double force_off = std::abs(f_h.y() - formula.force.y()) / f.y();
    const double torque_off = std::abs(tau_h.z() - formula.torque.z()) / (f.y() * kStickLength);
    return {.depth = depth,
            .force = f_h.y(),
            .torque = tau_h.z(),
            .formula_error = std::max(force_off, torque_off),
            .limited = (result.record.faults & (kForceClamped | kMotorClamped)) != 0};
  }
}

struct Moments {
  double mean = 0, deviation = 0;
};

Moments moments_of(const std::vector<double>& values) {
  Moments m;
  const auto n = static_cast<double>(values.size());
  for (const double v : values) m.mean += v / n;
  for (const double v : values) m.deviation += std::pow(v - m.mean, 2) / std::max(1.0, n - 1);
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
    const Felt felt =
        strike(std::move(*World::build(scene)), touch, path, row.method, static_cast<std::uint64_t>(s) + 1);
    const double wanted = (touch.place - touch.held) * touch.stiffness * felt.depth;
    stiffnesses.push_back(felt.force / felt.depth);
    torques.push_back(felt.torque - wanted);
    row.wanted_torque += wanted / strikes;
    row.formula_error = std::max(row.formula_error, felt.formula_error);
    row.limited += felt.limited ? 1 : 0;
  }
  const Moments k = moments_of(stiffnesses), torque = moments_of(torques);
  row.felt_stiffness = k.mean;
  row.stiffness_scatter = k.deviation;
  row.torque_error = torque.mean;
  row.torque_scatter = torque.deviation;
}

}  // namespace

std::string_view name_of(InertiaMethod method) {
  constexpr std::array<std::string_view, 3> names{"none", "arm", "acceleration"};
  return names[static_cast<std::size_t>(method)];
}

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
  study.late = study_late_compensation(bodies, device, study.hand, {kLateJerks.begin(), kLateJerks.end()});
  for (const InertiaMethod method : kMethods) {
    for (const double stiffness : kStiffnesses) {
      for (int i = 0; i < kPlaces; ++i)
        study.rows.push_back(
            {.method = method, .place = i * kStickLength / (kPlaces - 1), .stiffness = stiffness});
    }
  }
  for_each_piece(
      study.rows.size(), 0,
      [&](std::size_t i) { strike_often(study.rows[i], bodies, device, path, strikes); },
      [&progress](double fraction) { progress("strikes", fraction); });
  return study;
}

}  // namespace fulcrum::analysis
