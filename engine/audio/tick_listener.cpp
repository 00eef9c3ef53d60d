#include "engine/audio/tick_listener.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::audio {
namespace {

bool is_whole(const TickRecord& record) {
  return record.X_WH.p.allFinite() && record.X_WH.q.coeffs().allFinite() && record.X_WT.p.allFinite() &&
         record.V_WT.v.allFinite() && record.V_WT.w.allFinite() && record.contact_F_T_W.is_finite();
}

DeepestPointFinder finder_of(const SceneSound& desc) {
  if (desc.tool_features && desc.scene_features)
    return DeepestPointFinder(desc.tool_features, desc.scene_features);
  return DeepestPointFinder(desc.tool_shell.get(), desc.scene_field);
}

}  // namespace

TickListener::TickListener(const SceneSound& desc)
    : tick_s_(desc.tick_s),
      objects_(desc.objects),
      finder_(finder_of(desc)),
      apart_ticks_(std::llround(std::ceil(kApart / desc.tick_s))),
      over_ticks_(std::clamp<std::int64_t>(std::llround(kOver / desc.tick_s), 1, kPlaces - 1)),
      touched_at_(-apart_ticks_) {}

Heard TickListener::next(const TickRecord& record) {
  Heard heard;
  if (!is_whole(record)) return heard;
  const bool touches = record.regions > 0;
  const bool begins = touches && record.tick - touched_at_ > apart_ticks_;
  if (!touches)
    touch_.reset();
  else if (begins || !touch_ || record.tick - looked_at_ >= apart_ticks_)
    look(record);

  const bool moves = !record.stopped && !record.clutched;
  if (moves && record.impact) {
    const Impact& hardest = record.impact->hardest;
    if (record.impact->count > 0 && hardest.speed > 0)
      heard.blow = {hardest.p_W, hardest.speed, (hardest.p_W - record.X_WH.p).norm(), object_at(hardest.p_W)};
  } else if (moves && begins && touch_ && count_ > 0) {
    heard.blow = struck(record);
  }
  if (!record.stopped && touch_) {
    const Vec3 p_TC_W = record.X_WT.q * touch_->p_T;
    const Vec3 v_W = record.V_WT.v + record.V_WT.w.cross(p_TC_W);
    const Vec3& nhat_W = touch_->nhat_W;
    heard.slide = {record.X_WT.p + p_TC_W, (v_W - nhat_W * nhat_W.dot(v_W)).norm(),
                   record.contact_F_T_W.force.norm()};
  }
  if (touches) touched_at_ = record.tick;
  remember(record);
  return heard;
}

void TickListener::look(const TickRecord& record) {
  touch_ = finder_.find(record.X_WT);
  looked_at_ = record.tick;
}

// The hand goes on where the tool has been stopped already: it is the hand that says how hard the blow was.
std::optional<Blow> TickListener::struck(const TickRecord& record) const {
  const Place& before = place_before(record.tick);
  const auto ticks = static_cast<double>(record.tick - before.tick);
  if (!(ticks > 0)) return std::nullopt;
  const Vec3 p_W = record.X_WT * touch_->p_T;
  const Vec3 moved_W = p_W - before.X_WH * (record.X_WH.inverse() * p_W);
  const double speed = -moved_W.dot(touch_->nhat_W) / (ticks * tick_s_);
  if (!(speed >= kLeast)) return std::nullopt;
  return Blow{p_W, speed, (p_W - record.X_WH.p).norm(), object_at(p_W)};
}

// The newest that is at least over_ticks_ old, else the oldest.
const TickListener::Place& TickListener::place_before(std::int64_t tick) const {
  const std::size_t kept = std::min(count_, kPlaces);
  for (std::size_t back = 1; back <= kept; ++back) {
    const Place& place = places_[(count_ - back) % kPlaces];
    if (back == kept || tick - place.tick >= over_ticks_) return place;
  }
  return places_[0];
}

void TickListener::remember(const TickRecord& record) {
  places_[count_++ % kPlaces] = {record.tick, record.X_WH};
}

}  // namespace fulcrum::audio
