#pragma once
// How much a card holds ahead of what it plays. Less is felt sooner; too little, and it runs dry whenever a
// thread is late.

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "drivers/sound/pcm.h"

namespace fulcrum::sound {

struct FeedPlan {
  double tick = 48;          // frames of a tick; need not be whole
  std::int64_t floor = 0;    // frames: below it what nobody told is played, and is silence
  std::int64_t aim = 0;      // frames, at which the mean is held
  std::int64_t most = 0;     // frames: above it ticks are left out until it is back at the aim
  std::int64_t longest = 0;  // frames that one tick may have

  std::int64_t frames(double ticks) const { return static_cast<std::int64_t>(std::ceil(ticks * tick)); }
};

// The floor is a period, which a card takes at once, and 2 ms in which the feeding thread may be late. The
// aim leaves the haptic thread 4 ticks and 4 ms to be late; `most` has a gap's ticks, caught up at once, fit.
inline FeedPlan feed_plan(double tick_s, std::int64_t period) {
  constexpr double ms = kRate_Hz * 1e-3;
  FeedPlan plan;
  plan.tick = tick_s * kRate_Hz;
  plan.longest = plan.frames(1) + 1;
  plan.floor = period + static_cast<std::int64_t>(2 * ms);
  plan.aim = plan.floor + std::max(plan.frames(4), static_cast<std::int64_t>(4 * ms));
  plan.most = plan.aim + std::max(plan.frames(6), static_cast<std::int64_t>(8 * ms));
  return plan;
}

}  // namespace fulcrum::sound
