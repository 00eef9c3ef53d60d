#pragma once
// Which buttons of a gamepad have gone down since the last look; one that repeats goes down again and again
// while it is held, as a keyboard's keys do.

#include <cstdint>
#include <limits>
#include <utility>

namespace fulcrum::input {

class PadPresses {
public:
  static constexpr double kFirst = 0.4, kNext = 0.1;  // s, until it repeats, and from then on
  // For so many looks it is held before it repeats: where a picture takes long, a short press lasts, too.
  static constexpr int kLooks = 6;

  explicit PadPresses(std::uint32_t repeating) : repeating_(repeating) {}

  // down: a bit for each. now: s, of any steady clock.
  std::uint32_t pressed(std::uint32_t down, double now) {
    const std::uint32_t fresh = down & ~std::exchange(before_, down);
    looks_ = fresh != 0 ? 0 : looks_ + 1;
    if (fresh != 0) due_ = now + kFirst;
    const std::uint32_t held = down & repeating_;
    if (fresh != 0 || held == 0 || now < due_ || looks_ < kLooks) return fresh;
    due_ = now + kNext;
    return held;
  }

private:
  std::uint32_t repeating_,
      before_ = ~std::uint32_t{0};  // what is down at first was meant for what was before
  double due_ = std::numeric_limits<double>::infinity();  // s
  int looks_ = 0;                                         // since a button went down
};

}  // namespace fulcrum::input
