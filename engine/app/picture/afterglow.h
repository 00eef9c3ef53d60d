#pragma once
// What stays to be seen of ticks for a while. A frame shows one tick of many: a pulse of one tick would be
// missed by most.

#include <array>
#include <optional>
#include <span>
#include <vector>

#include "engine/app/picture/impact_circle.h"
#include "engine/ui/peak_hold.h"
#include "haptics/tick/knob.h"
#include "haptics/world/tick_record.h"

namespace fulcrum::app {

class Afterglow {
public:
  // p_TH: (3) m, the manipulation point, where the tool has it.
  explicit Afterglow(const Vec3& p_TH) : p_TH_(p_TH) {}
  Afterglow() = default;  // of nothing

  // Every tick, in order. time: s, simulated. knobs: of the tick; only the brief ones are looked at.
  void add(const TickRecord& record, double time, std::span<const Knob> knobs = {});

  // A motor's largest loads of the last moments, fractions of its limit; low <= 0 <= high.
  struct Peaks {
    double low = 0, high = 0;
  };
  const std::array<Peaks, kMaxMotors>& motors() const { return motors_; }

  // 0 to 1: how strong a brief effect was in the last moments, by the command that sets its knob.
  double peak(Command::Kind kind) const;

  // The newest impact that was felt.
  const std::optional<StruckPlace>& struck() const { return struck_; }

private:
  Vec3 p_TH_ = Vec3::Zero();
  std::array<ui::PeakHold, kMaxMotors> low_, high_;
  std::array<Peaks, kMaxMotors> motors_{};
  struct Level {
    Command::Kind kind;
    ui::PeakHold hold{};
    double peak = 0;
  };
  std::vector<Level> levels_;  // of the brief knobs
  std::optional<StruckPlace> struck_;
};

}  // namespace fulcrum::app
