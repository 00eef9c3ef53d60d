#include "engine/analysis/uniformity/stick_strike.h"

#include <algorithm>
#include <cmath>

#include "haptics/device/hand.h"
#include "haptics/math/functions.h"
#include "haptics/math/split_mix.h"
#include "haptics/safety/faults.h"

namespace fulcrum::analysis::uniformity {
namespace {

// Ticks at rest, by which force, and after it compensation, have come in.
constexpr int kForceIn = 510, kCompensationIn = 1020;
constexpr double kDifference = 1e-4;  // s, of tremor's acceleration

// Where the handle is, from where the stick just touches, and how it accelerates.
class HandleWay {
public:
  HandleWay(const StrikePath& path, double rest, std::uint64_t seed)
      : path_(path), rest_(rest), tremor_(shaking(path, seed)) {}

  Vec3 p(double t) const {
    const double half = std::sqrt(path_.travel / path_.acceleration), a = path_.acceleration;
    const double top = path_.travel - path_.depth - path_.beyond, s = std::max(0.0, t - rest_);
    const double y =
        s < half ? top - 0.5 * a * s * s : top - path_.travel + 0.5 * a * math::square(2 * half - s);
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

// By the formulas, at G: what the method is to make of a contact force f at `l` from C, where the device is
// slowed down by `inertia` and resisted by `resistance`.
Wrench by_formula(InertiaMethod method, const StickTouch& touch, const Vec3& f, const Vec3& inertia,
                  const Vec3& resistance) {
  const Vec3 l(touch.place, -kStickRadius, 0), g(touch.held, 0, 0), h = l - g;
  const Vec3 at_stage = method == InertiaMethod::acceleration ? resistance : Vec3(resistance - inertia);
  Wrench felt{f + at_stage, h.cross(f) - g.cross(at_stage)};
  const bool between = touch.place <= touch.held;
  if (method == InertiaMethod::arm && between) felt.torque -= g.cross(f + resistance);
  return felt;
}

}  // namespace

StrikeOutcome strike(World world, const StickTouch& touch, const StrikePath& path, InertiaMethod method,
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
    // The formulas tell of the force of the contact, whatever depth it was found at.
    const TickRecord& record = result.record;
    const Vec3 f(0, touch.stiffness * record.depth_max, 0);
    const Vec3& resistance = world.resistance_F_H_D().force;
    const Wrench formula = by_formula(method, touch, f, inertia, resistance);
    return {.depth = depth,
            .force = f_h.y(),
            .torque = tau_h.z(),
            .depth_error = std::abs(record.depth_max - depth),
            .resistance = resistance.y(),
            .force_off = std::abs(f_h.y() / formula.force.y() - 1),
            .torque_off = std::abs(tau_h.z() - formula.torque.z()) /
                          std::max(std::abs(formula.torque.z()), kTorqueLeast),
            .limited = (record.faults & (kForceClamped | kMotorClamped)) != 0};
  }
}

}  // namespace fulcrum::analysis::uniformity
