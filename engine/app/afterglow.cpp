#include "engine/app/afterglow.h"

#include <algorithm>
#include <utility>

namespace fulcrum::app {

void Afterglow::add(const TickRecord& record, double time) {
  for (std::size_t i = 0; i < kMaxMotors; ++i) {
    const double load = record.actuator_load[i];
    motors_[i] = {-low_[i].add(std::max(-load, 0.0), time), high_[i].add(std::max(load, 0.0), time)};
  }
  if (auto struck = struck_place(record, p_TH_, time)) struck_ = std::move(struck);
  if (!record.braking_pulse) return;
  pulse_force_ = force_.add(record.braking_pulse->force_share, time);
  pulse_moment_ = moment_.add(record.braking_pulse->moment_share, time);
}

}  // namespace fulcrum::app
