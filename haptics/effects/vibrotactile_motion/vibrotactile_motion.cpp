#include "haptics/effects/vibrotactile_motion/vibrotactile_motion.h"

#include <algorithm>
#include <cmath>

#include "haptics/actuation/vibrotactile_actuator.h"
#include "haptics/safety/guard.h"

namespace fulcrum {
namespace {

// m of the line along which the window lies, back, that are a turn: a way of the hand, and where the window
// is short, a tenth of it.
double least_turn(const VibrotactileMotionDesc& desc, double position_scale) {
  const double scale = desc.use == VibrotactileUse::sweep ? position_scale : 1.0;
  return std::min(SweepDirection::kMin * scale, 0.1 * desc.law.window);
}

}  // namespace

VibrotactileMotion::VibrotactileMotion(const VibrotactileMotionDesc& desc, const VibrotactileDesc* channels,
                                       double position_scale, double tick_s)
    : desc_(desc),
      tick_s_(tick_s),
      way_direction_(least_turn(desc, position_scale), tick_s),
      force_(1 / desc.update_Hz, tick_s) {
  desc_.axis_W.normalize();
  record_.gain = desc_.gain;
  if (channels == nullptr) return;
  left_ = channels->find("left").value_or(0);
  right_ = channels->find("right").value_or(0);
  channels_ = channels->channels.size();
  for (std::size_t i = 0; i < channels_; ++i)
    reach_[i] = actuator_reach(channels->channels[i], desc_.carrier_Hz);
}

VibrotactileMotion::Place VibrotactileMotion::sweep(const Tick& tick) noexcept {
  Place place;
  const double x = desc_.axis_W.dot(tick.p_WH - desc_.centre_W);
  record_.x = x;
  place.speed = desc_.axis_W.dot(tick.v_WH);
  place.direction = way_direction_.update(x);
  place.x = place.direction * x;
  const bool inside =
      place.direction != 0 && tick.touching && tick.engaged && place.x >= 0 && place.x <= desc_.law.window;
  place.share = inside ? 1.0 : 0.0;
  place.begins = inside && inside_ != place.direction;
  return place;
}

VibrotactileMotion::Place VibrotactileMotion::fall_back(const Tick& tick) noexcept {
  Place place;
  way_ += tick.moved;
  place.speed = tick.speed;
  place.direction = way_direction_.update(way_);
  const bool resisted = tick.engaged && place.direction * tick.felt < 0;
  place.share = resisted ? std::min(1.0, std::abs(tick.felt) / desc_.full_force) : 0.0;
  place.begins = resisted && inside_ != place.direction;
  if (place.begins || place.direction * (way_ - begin_) < 0) begin_ = way_;  // back, but not turned round
  place.x = place.direction * (way_ - begin_);
  if (place.x > desc_.law.window) {
    place.x = std::fmod(place.x, desc_.law.window);
    begin_ = way_ - place.direction * place.x;
    place.begins = resisted;
  }
  record_.x = resisted ? place.direction * place.x : 0.0;
  return place;
}

Vec3 VibrotactileMotion::process(const Tick& tick) noexcept {
  const Place place = desc_.use == VibrotactileUse::sweep ? sweep(tick) : fall_back(tick);
  record_.direction = place.direction;

  const int inside = place.share > 0 ? place.direction : 0;
  if (place.begins) onset_ = trailing_onset(desc_.law, place.speed);
  const bool second = inside != 0 && onset_ > 0 && place.x > onset_;
  const bool at_once = place.begins || inside != inside_ || second != second_ || changed_;
  inside_ = inside;
  second_ = second;
  changed_ = false;
  const bool fast = std::abs(place.speed) > kFast;
  phase_ += tick_s_ * desc_.update_Hz;
  constexpr double rounding = 1e-9;
  if (!tick.stopped && (at_once || fast || phase_ >= 1 - rounding)) {
    phase_ = at_once || fast ? 0.0 : phase_ - std::floor(phase_ + rounding);
    glide_ = std::max(tick_s_, fast ? 0.0 : 1 / desc_.update_Hz);
    update(place);
  }

  if (desc_.lateral_force == 0) return Vec3::Zero();
  const double force = desc_.lateral_force * force_.towards(inside != 0 && record_.gain > 0 ? 1.0 : 0.0);
  record_.force = -std::clamp(place.speed / desc_.full_speed, -1.0, 1.0) * force;
  return record_.force * desc_.axis_W;
}

void VibrotactileMotion::update(const Place& place) noexcept {
  MotionLevels levels;
  if (place.share > 0) levels = motion_levels(desc_.law, place.x, onset_);
  const bool rightwards = place.direction > 0;
  left_share_ = place.share * (rightwards ? levels.trailing : levels.leading);
  right_share_ = place.share * (rightwards ? levels.leading : levels.trailing);
}

const VibrotactileCommand& VibrotactileMotion::render(double guard_gain, bool stopped) noexcept {
  record_.shortfall = 0;
  if (channels_ == 0) return record_.command;
  const auto give = [this](std::size_t channel, double wanted) {
    record_.command.level[channel] = std::min(wanted, reach_[channel]);
    record_.shortfall = std::max(record_.shortfall, wanted - record_.command.level[channel]);
  };
  const double strength = desc_.strength * record_.gain * guard_gain;
  give(left_, strength * left_share_);
  give(right_, strength * right_share_);
  record_.command.glide = stopped ? std::min(tick_s_, kStopFall) : glide_;
  record_.command.stopping = stopped;
  return record_.command;
}

void VibrotactileMotion::apply(const Command& command) noexcept {
  if (command.kind != Command::Kind::vibrotactile_gain || channels_ == 0) return;
  record_.gain = command.gain();
  changed_ = true;
}

}  // namespace fulcrum
