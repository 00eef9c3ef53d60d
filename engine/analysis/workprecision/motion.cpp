// Integrators, against motions known in closed form.

#include <cmath>

#include "engine/analysis/best_time.h"
#include "engine/analysis/workprecision/workprecision.h"
#include "haptics/math/rotation.h"
#include "haptics/tool/rigid_body.h"

namespace fulcrum::analysis::workprecision {
namespace {

struct Named {
  const char* name;
  Integrator integrator;
};
constexpr Named kIntegrators[] = {{"semi_implicit_euler", Integrator::semi_implicit_euler},
                                  {"implicit_euler", Integrator::implicit_euler},
                                  {"momentum", Integrator::momentum}};

void advance(const RigidBody& body, Integrator integrator, const Linearisation& around, double tick,
             BodyState& state) {
  const Vec6 B_v = around.B * (Vec6() << state.V_WT.v, state.V_WT.w).finished();
  const Wrench F{-around.K.topLeftCorner<3, 3>() * state.X_WT.p - B_v.head<3>(), -B_v.tail<3>()};
  RigidBody::Move move;
  switch (integrator) {
    case Integrator::semi_implicit_euler:
      move.during = move.after = body.accelerate(state, F, tick);
      break;
    case Integrator::implicit_euler:
      move.during = move.after = body.accelerate(state, F, around, tick);
      break;
    case Integrator::momentum:
      move = body.accelerate_keeping_momentum(state, F, tick);
      break;
  }
  state.X_WT = RigidBody::advance(state.X_WT, move.during, tick);
  state.V_WT = move.after;
}

struct Task {
  RigidBody body;
  Linearisation around;
  BodyState start;
  double seconds;
};

// Error of each integrator over ticks; cost of one tick.
template <class Error>
void measure(WorkStudy& study, const Task& task, const std::vector<double>& ticks_ms, const Error& error) {
  for (const Named& named : kIntegrators) {
    for (const double tick_ms : ticks_ms) {
      const double tick = 1e-3 * tick_ms;
      const auto steps = std::lround(task.seconds / tick);
      BodyState state;
      const double us = best_us([&] {
        state = task.start;
        for (long i = 0; i < steps; ++i) advance(task.body, named.integrator, task.around, tick, state);
      });
      study.points.push_back({named.name, tick_ms, error(state), us / task.seconds * 1e-3});
    }
  }
  measure_orders(study);
}

}  // namespace

WorkStudy study_oscillator(bool quick) {
  WorkStudy study{
      "oscillator",
      "A damped oscillator, m = 0.05 kg, k = 1000 N/m, c = 2 N s/m, let go at 1 mm: after 0.05 s it is at "
      "0.3118725489962 mm. The work is a millisecond of its motion.",
      "tick (ms)",
      "m",
      {{"semi_implicit_euler", 1}, {"implicit_euler", 1}, {"momentum", 1}},
      {}};
  Task task{RigidBody(0.05, Mat3::Identity()), {}, {}, 0.05};
  task.around.K.topLeftCorner<3, 3>() = 1000 * Mat3::Identity();
  task.around.B.topLeftCorner<3, 3>() = 2 * Mat3::Identity();
  task.start.X_WT.p.x() = 1e-3;
  measure(study, task, quick ? std::vector{0.1, 0.05} : std::vector{1.0, 0.5, 0.25, 0.125, 0.0625, 0.03125},
          [](const BodyState& state) { return std::abs(state.X_WT.p.x() - 0.3118725489962e-3); });
  return study;
}

WorkStudy study_tumbling(bool quick) {
  WorkStudy study{
      "top",
      "A free symmetric top, I = (1, 1, 2), w = (0.5, 0, 1): where it points after 10 s is known in closed "
      "form. The work is a millisecond of its motion.",
      "tick (ms)",
      "rad",
      {{"semi_implicit_euler", 1}, {"implicit_euler", 1}, {"momentum", 2}},
      {}};
  Mat3 inertia = Mat3::Identity();
  inertia(2, 2) = 2;
  Task task{RigidBody(1, inertia), {}, {}, 10};
  task.start.V_WT.w = Vec3(0.5, 0, 1);
  const Quat truth(0.53869788, -0.05315610, 0.17969498, -0.82139439);
  measure(
      study, task, quick ? std::vector{20.0, 10.0} : std::vector{40.0, 20.0, 10.0, 5.0, 2.5},
      [&truth](const BodyState& state) { return rotation_vector(state.X_WT.q * truth.conjugate()).norm(); });
  return study;
}

}  // namespace fulcrum::analysis::workprecision
