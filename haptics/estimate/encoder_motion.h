#pragma once
// How far a handle went in a tick whose encoders count in steps. Slower than a step a tick, the handle stands
// for some ticks and then jumps by a whole step, of which it went only a part within that tick. The energy
// that a held force took or gave needs that part: booked by whole steps, a spring k seems to leak k step^2 /
// 2 at every count, which a hand that trembles across one count would do for ever.

#include <array>

#include "haptics/math/linear.h"

namespace fulcrum {

inline constexpr double kOneCount = 1.5;  // of a step: less is a single count, more are several

class EncoderMotion {
public:
  // step (6): of one count in each axis, m and rad; 0: the axis is exact.
  explicit EncoderMotion(const Vec6& step) : step_(step) {}

  // d (6): what was counted in this tick, m and rad.
  void update(const Vec6& d) noexcept;
  // The same of a way that the handle has not gone within the tick, such as a device's error or what lies
  // between samples that could not be used: it is no speed, and the next count begins anew.
  void jump(const Vec6& d) noexcept;

  // (6) m and rad: how far the handle went within this tick.
  //     two counts or more in the tick:  all of d
  //     one count after n idle ticks:    d / n
  //     the first count after a turn:    0
  const Vec6& within_tick() const { return within_; }
  // (6) m and rad per tick: speed, between counts too, falling as the next count is overdue.
  const Vec6& per_tick() const { return rate_; }

private:
  Vec6 step_;
  Vec6 within_ = Vec6::Zero();
  Vec6 rate_ = Vec6::Zero();
  Vec6 last_ = Vec6::Zero();    // of the last count, signed
  std::array<int, 6> since_{};  // ticks since it
};

}  // namespace fulcrum
