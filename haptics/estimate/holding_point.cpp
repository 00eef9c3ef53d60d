#include "haptics/estimate/holding_point.h"

#include <algorithm>
#include <cmath>

namespace fulcrum {

HoldingPoint::HoldingPoint(const HoldingPointDesc& desc, const std::optional<HoldingStripDesc>& strip,
                           double tick_s)
    : desc_(desc),
      strip_(strip),
      tick_s_(tick_s),
      measure_(desc.measured),
      told_(desc.place),
      place_(desc.place),
      state_(desc.measured ? HoldingState::lost : HoldingState::set),
      last_trusted_(desc.place),
      lost_for_(desc.keep + desc.fade) {}  // nothing was ever trusted

void HoldingPoint::tell(double place) noexcept {
  if (std::isfinite(place)) told_ = place;
}

void HoldingPoint::update(double strip_ohm) noexcept {
  // No resistance is a short circuit, not a place.
  const double to = wanted(strip_ && strip_ohm > 0 ? place_of(*strip_, strip_ohm) : kNoStrip);
  const double most = desc_.speed * tick_s_;
  place_ += std::clamp(std::clamp(to, desc_.low, desc_.high) - place_, -most, most);
}

bool HoldingPoint::trusted(double reading) noexcept {
  if (!strip_ || !(reading >= strip_->low_place - desc_.margin) ||
      !(reading <= strip_->high_place + desc_.margin)) {
    reading_.reset();
    still_ = 0;
    return false;
  }
  const bool still = reading_ && std::abs(reading - *reading_) <= desc_.stillness;
  still_ = still ? still_ + tick_s_ : 0;
  reading_ = reading;
  return still_ >= desc_.settle;
}

double HoldingPoint::wanted(double reading) noexcept {
  if (trusted(reading)) {
    const double follow = tick_s_ / (tick_s_ + desc_.smoothing);
    smooth_ = smooth_ ? *smooth_ + follow * (reading - *smooth_) : reading;
    last_trusted_ = *smooth_;
    lost_for_ = 0;
  } else {
    smooth_.reset();
    lost_for_ = std::min(lost_for_ + tick_s_, desc_.keep + desc_.fade);
  }
  if (!measure_) {
    state_ = HoldingState::set;
    return told_;
  }
  if (smooth_) {
    state_ = HoldingState::measured;
    return *smooth_;
  }
  if (lost_for_ < desc_.keep) {
    state_ = HoldingState::kept;
    return last_trusted_;
  }
  const double gone = (lost_for_ - desc_.keep) / desc_.fade;
  if (gone < 1) {
    state_ = HoldingState::fading;
    return last_trusted_ + gone * (desc_.place - last_trusted_);
  }
  state_ = HoldingState::lost;
  return desc_.place;
}

}  // namespace fulcrum
