// The tick: what a hand feels of a motion whose force is known at every moment.

#include <array>
#include <cmath>
#include <complex>
#include <numbers>

#include "engine/analysis/best_time.h"
#include "engine/analysis/shapes.h"
#include "engine/analysis/workprecision/bodies.h"
#include "engine/analysis/workprecision/workprecision.h"
#include "haptics/math/functions.h"
#include "haptics/world/world.h"

namespace fulcrum::analysis::workprecision {
namespace {

// The hand is kMean + kSwing sin(w t) beyond the wall.
constexpr double kMean = 1e-3, kSwing = 0.5e-3;     // m
constexpr double kTurn = 2 * std::numbers::pi * 2;  // rad/s
constexpr double kSettled = 0.5, kEnd = 1;          // s: measured in between, one turn
constexpr double kBallRadius = 5e-3;                // m

struct TickMethod {
  const char* name;
  ContactResponse response;
  Integrator integrator;
};
constexpr TickMethod kMethods[] = {
    {"penalty, semi-implicit Euler", ContactResponse::penalty, Integrator::semi_implicit_euler},
    {"penalty, implicit Euler", ContactResponse::penalty, Integrator::implicit_euler},
    {"static", ContactResponse::quasi_static, Integrator::implicit_euler},
    {"constraint", ContactResponse::constraint, Integrator::implicit_euler}};

SceneDesc scene(const TickMethod& method, const std::shared_ptr<const DistanceField>& floor, double tick_s) {
  SceneDesc desc;
  desc.tick_s = tick_s;
  desc.tool.mass = 0.2;
  desc.tool.inertia_T = Mat3::Identity() * 5.3e-5;
  desc.tool.weight = false;
  desc.tool.X_WT_start.p.y() = kBallRadius;
  desc.tool_shell =
      shell_touching(std::array{Vec3(0, -kBallRadius, 0)}, std::array{Vec3(0, -1, 0)}, 0.75 * kBallRadius);
  desc.scene_field = floor;
  desc.velocity.kind = VelocityEstimatorKind::difference;
  desc.coupling.stiffness = 1000;
  desc.coupling.angular_stiffness = 0.3;
  desc.coupling.max_force = 1e5;
  desc.contact.response = method.response;
  desc.contact.stiffness = 2000;
  desc.contact.dissipation = 0;
  desc.integrator = method.integrator;
  return desc;
}

// Of the coupling, at any time: what an infinitely short tick would make of it. With G the hand's swing, the
// tool's is X = c G / (c + k - m w^2), c = k_c + i w b; the force's is c (G - X).
class Truth {
public:
  explicit Truth(const SceneDesc& desc) {
    const bool massless = fulcrum::massless(desc.contact.response);
    const bool rigid = desc.contact.response == ContactResponse::constraint;
    const double k_c = desc.coupling.stiffness, k = desc.contact.stiffness;
    const double braked = massless ? desc.device.handle_mass : desc.tool.mass;
    const double moved = massless ? 0 : desc.tool.mass;
    const std::complex<double> c(k_c, kTurn * 2 * desc.coupling.damping_ratio * std::sqrt(k_c * braked));
    // Where the tool has no mass, springs alone say where it is; the damper is felt on top of them.
    const std::complex<double> pulls = massless ? k_c : c;
    const std::complex<double> yields = rigid ? 0 : pulls / (pulls + k - moved * kTurn * kTurn);
    swing_ = c * (1.0 - yields) * kSwing;
    mean_ = k_c * (rigid ? 1 : k / (k_c + k)) * kMean;
  }
  double operator()(double t) const {
    return mean_ + std::imag(swing_ * std::complex(math::cos(kTurn * t), math::sin(kTurn * t)));
  }

private:
  double mean_ = 0;             // N
  std::complex<double> swing_;  // N
};

// What the hand feels, held from tick to tick, against the truth at eight moments in each.
double run(const SceneDesc& desc) {
  World world = std::move(*World::build(desc));
  const Truth truth(desc);
  const auto ticks = std::lround(kEnd / desc.tick_s), settled = std::lround(kSettled / desc.tick_s);
  double off = 0, all = 0;
  DeviceSample sample;
  for (long i = 0; i < ticks; ++i) {
    const double t = static_cast<double>(i) * desc.tick_s;
    sample.X_DH.p.y() = kBallRadius - kMean - kSwing * math::sin(kTurn * t);
    const double felt = -step(world, sample, {}).record.coupling_F_T_W.force.y();
    if (i < settled) continue;
    constexpr int moments = 8;
    for (int j = 0; j < moments; ++j) {
      const double now = truth(t + (j + 0.5) / moments * desc.tick_s);
      off += (felt - now) * (felt - now);
      all += now * now;
    }
  }
  return std::sqrt(off / all);
}

}  // namespace

WorkStudy study_tick(bool quick) {
  WorkStudy study{
      "tick",
      "A hand that presses a ball against a floor, 1 mm deep and 0.5 mm more and less, twice a second. The "
      "force in the coupling is known at every moment: a mass of 0.2 kg between springs of 1000 and 2000 N/m "
      "(penalty), springs alone (static), a tool that stays out (constraint), each with its coupling's "
      "damper. "
      "What the hand feels is held from tick to tick; the error is its root mean square distance from the "
      "truth between ticks, too, of the truth. That hold is of order 1, whatever lies behind it: an "
      "integrator of "
      "higher order would not be felt here, a shorter tick is. The tool's shell has 4096 points; the work is "
      "a second of motion.",
      "tick (ms)",
      "",
      {},
      {}};
  const auto floor = field_of(box_mesh({-0.02, -0.01, -0.02}, {0.02, 0, 0.02}), 0.5e-3);
  for (const TickMethod& method : kMethods) {
    study.expected_order.emplace_back(method.name, 1);
    for (const double tick_ms : quick ? std::vector{1.0, 0.5} : std::vector{4.0, 2.0, 1.0, 0.5, 0.25}) {
      const SceneDesc desc = scene(method, floor, 1e-3 * tick_ms);
      double error = 0;
      const double us = best_us([&] { error = run(desc); });
      study.points.push_back({method.name, tick_ms, error, us});
    }
  }
  measure_orders(study);
  return study;
}

}  // namespace fulcrum::analysis::workprecision
