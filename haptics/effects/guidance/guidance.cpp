#include "haptics/effects/guidance/guidance.h"

#include <algorithm>

namespace fulcrum {
namespace {

std::optional<DampedSpring> spring_of(const GuidanceDesc& desc, const Guidance::Surroundings& of) {
  const double max_force = desc.max_force.value_or(Guidance::kForceShare * of.device.max_force);
  if (!of.device.renders_force || !(max_force > 0)) return std::nullopt;
  const double until_whole = Guidance::kBandsToWhole * desc.dead_band / of.mapping.position_scale;
  return DampedSpring(
      desc.stiffness ? *desc.stiffness : DampedSpring::suited(of.device, of.tick_s, max_force / until_whole),
      max_force, of.device, of.tick_s);
}

}  // namespace

Guidance::Guidance(const GuidanceDesc& desc, const Surroundings& of)
    : desc_(desc),
      way_(desc.way, of.p_TH),
      mapping_(of.mapping),
      window_(desc.window.value_or(kBandsOfWindow * desc.dead_band)),
      tick_s_(of.tick_s),
      spring_(spring_of(desc, of)),
      ramp_(kRamp, of.tick_s),
      place_(way_.nearest(0, Vec3::Zero(), 0, 0)) {
  desc_.way.clear();  // way_ has it
  record_.gain = desc.gain;
}

void Guidance::apply(const Command& command) noexcept {
  if (command.kind == Command::Kind::guidance_gain) record_.gain = command.gain();
}

Vec3 Guidance::process(const Tick& tick) noexcept {
  if (record_.gain == 0 && record_.level == 0) {
    if (follows_ || found_) {  // it has just gone
      const double time = record_.time;
      record_ = {};
      record_.time = time;
      found_.reset();
      follows_ = false;
      spring_energy_ = 0;
    }
    watch_rests(tick.p_WH);
    return Vec3::Zero();
  }
  if (!follows_) follows_ = search(tick.p_WH);
  if (follows_) {
    follow(tick.p_WH);
    pull(tick);
  }
  return record_.force_D;
}

void Guidance::watch_rests(const Vec3& p_WH) noexcept {
  if (next_rest_ == way_.rests().size()) return;
  const GuidanceWay::Place& rest = way_.rests()[next_rest_];
  if ((p_WH - rest.p_WH).squaredNorm() > window_ * window_) return;
  ++next_rest_;
  place_ = rest;
  record_.time = way_.time(place_);
}

// True once all of the way is looked through. The handle moves meanwhile: by the end place_ may be a little
// behind it, and goes on from there.
bool Guidance::search(const Vec3& p_WH) noexcept {
  if (!found_) {
    found_.emplace(way_.nearest(place_.piece, p_WH, place_.part, place_.part),
                   kMarginOfBand * desc_.dead_band);
    searched_ = place_.piece;
  }
  const std::size_t end = std::min(way_.pieces(), searched_ + kSearched);
  for (; searched_ < end; ++searched_)
    found_->note(way_.nearest(searched_, p_WH, searched_ == place_.piece ? place_.part : 0, 1), 1);
  if (searched_ < way_.pieces()) return false;
  place_ = found_->best();
  found_.reset();
  return true;
}

void Guidance::follow(const Vec3& p_WH) noexcept {
  NearestOnWay nearest(way_.nearest(place_.piece, p_WH, place_.part, place_.part),
                       kMarginOfBand * desc_.dead_band);
  const std::size_t end = std::min(way_.pieces(), place_.piece + GuidanceWay::kMostAhead);
  double left = window_, from = place_.part;
  for (std::size_t piece = place_.piece; piece < end; ++piece) {
    const double length = way_.length(piece);
    const double to = length > 0 ? std::min(1.0, from + left / length) : 1.0;
    nearest.note(way_.nearest(piece, p_WH, from, to), to);
    if (to < 1) break;
    left = std::max(0.0, left - (to - from) * length);
    from = 0;
  }
  place_ = nearest.best();
  while (next_rest_ < way_.rests().size() && way_.rests()[next_rest_].piece < place_.piece) ++next_rest_;
  record_.time = way_.time(place_);
  record_.distance = place_.distance;
  record_.X_WT_ahead = way_.X_WT_after(place_, desc_.ahead);
}

void Guidance::pull(const Tick& tick) noexcept {
  if (!tick.engaged) ramp_ = Ramp(kRamp, tick_s_);
  const double before = record_.level;
  record_.level = tick.engaged ? ramp_.towards(record_.gain) : 0;
  record_.force_D.setZero();
  if (!spring_) return;
  spring_->move(tick.per_tick_D);
  const Vec3 e_D = mapping_.X_WD.q.conjugate() * (place_.p_WH - tick.p_WH) / mapping_.position_scale;
  const double size = e_D.norm(), s = size - desc_.dead_band / mapping_.position_scale;
  spring_energy_ = s > 0 ? spring_->stored(s) : 0;
  let_in_ += std::max(0.0, record_.level - before) * spring_energy_;
  if (!(s > 0)) return;
  const Vec3 towards_D = e_D / size;
  record_.force_D = record_.level * spring_->push(s, -towards_D) * towards_D;
}

}  // namespace fulcrum
