#include "haptics/effects/torque_substitution/vibration_cue.h"

#include <algorithm>

#include "haptics/math/functions.h"

namespace fulcrum {
namespace {

constexpr double kFelt = 0.1;       // N: a smaller force has no direction worth turning for
constexpr double kAlongside = 0.1;  // sine of the angle below which two directions are the same

}  // namespace

VibrationCue::VibrationCue(const VibrationDesc& desc, double tick_s)
    : desc_(desc),
      sine_(desc.frequency_Hz, tick_s),
      ramp_(kSwell, tick_s),
      turning_(1 - math::exp(-tick_s / kTurn)) {}

double VibrationCue::strength(double torque) const noexcept {
  return std::min(1.0, math::log1p(torque / desc_.reference) / math::log1p(desc_.largest / desc_.reference));
}

Vec3 VibrationCue::process(double level, const Vec3& felt_D) noexcept {
  if (ramp_.towards(level) == 0.0) {
    sine_.restart();
    turn(felt_D);
    direction_ = wanted_D_;  // nobody feels it turn
    return Vec3::Zero();
  }
  turn(felt_D);
  direction_ += turning_ * (wanted_D_ - direction_);
  return amplitude() * sine_.next() * direction_;
}

void VibrationCue::turn(const Vec3& felt_D) noexcept {
  const double felt = felt_D.norm();
  if (!(felt > kFelt)) return;
  const Vec3 f = felt_D / felt;
  Vec3 across = wanted_D_ - f * f.dot(wanted_D_);
  if (across.norm() < kAlongside) across = f.unitOrthogonal();
  wanted_D_ = across.normalized();
}

}  // namespace fulcrum
