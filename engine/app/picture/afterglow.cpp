#include "engine/app/picture/afterglow.h"

#include <algorithm>
#include <utility>

namespace fulcrum::app {

void Afterglow::add(const TickRecord& record, double time, std::span<const Knob> knobs) {
  for (std::size_t i = 0; i < kMaxMotors; ++i) {
    const double load = record.actuator_load[i];
    motors_[i] = {-low_[i].add(std::max(-load, 0.0), time), high_[i].add(std::max(load, 0.0), time)};
  }
  if (auto struck = struck_place(record, p_TH_, time)) struck_ = std::move(struck);
  for (const Knob& knob : knobs) {
    if (!knob.brief) continue;
    auto level = std::ranges::find(levels_, knob.kind, &Level::kind);
    if (level == levels_.end()) level = levels_.insert(level, Level{knob.kind});
    level->peak = level->hold.add(knob.level, time);
  }
}

double Afterglow::peak(Command::Kind kind) const {
  const auto level = std::ranges::find(levels_, kind, &Level::kind);
  return level == levels_.end() ? 0 : level->peak;
}

}  // namespace fulcrum::app
