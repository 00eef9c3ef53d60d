#pragma once
// What stays to be seen of ticks for a while. A frame shows one tick of many: a pulse of one tick would be
// missed by most.

#include <array>
#include <optional>

#include "engine/app/impact_circle.h"
#include "engine/ui/peak_hold.h"
#include "haptics/world/tick_record.h"

namespace fulcrum::app {

class Afterglow {
public:
  // p_TH: (3) m, the manipulation point, where the tool has it.
  explicit Afterglow(const Vec3& p_TH) : p_TH_(p_TH) {}
  Afterglow() = default;  // of nothing

  // Every tick, in order. time: s, simulated.
  void add(const TickRecord& record, double time);

  // A motor's largest loads of the last moments, fractions of its limit; low <= 0 <= high.
  struct Peaks {
    double low = 0, high = 0;
  };
  const std::array<Peaks, kMaxMotors>& motors() const { return motors_; }

  // Likewise, 0 to 1: of a braking pulse's force and moment, what the motors gave.
  double pulse_force() const { return pulse_force_; }
  double pulse_moment() const { return pulse_moment_; }

  // The newest impact that was felt.
  const std::optional<StruckPlace>& struck() const { return struck_; }

private:
  Vec3 p_TH_ = Vec3::Zero();
  std::array<ui::PeakHold, kMaxMotors> low_, high_;
  std::array<Peaks, kMaxMotors> motors_{};
  ui::PeakHold force_, moment_;
  double pulse_force_ = 0, pulse_moment_ = 0;
  std::optional<StruckPlace> struck_;
};

}  // namespace fulcrum::app
