#pragma once
// Whether so many ticks were late or lost of late that a hand feels it.

#include <cstdint>

namespace fulcrum::app {

class TickTrouble {
public:
  static constexpr double kWindow = 2;       // s, that are looked at together
  static constexpr double kLateShare = 0.1;  // of the ticks: fewer are the machine's own unrest

  TickTrouble() = default;  // of nothing: there is none
  explicit TickTrouble(double tick_s) : window_(static_cast<std::uint64_t>(kWindow / tick_s)) {}

  // How many there have been so far.
  void note(std::uint64_t ticks, std::uint64_t late, std::uint64_t lost) {
    if (ticks - from_.ticks < window_) return;
    const auto passed = static_cast<double>(ticks - from_.ticks);
    trouble_ = lost > from_.lost || static_cast<double>(late - from_.late) >= kLateShare * passed;
    from_ = {ticks, late, lost};
  }
  // In the last whole window.
  bool is_there() const { return trouble_; }

private:
  struct Counts {
    std::uint64_t ticks = 0, late = 0, lost = 0;
  };
  std::uint64_t window_ = ~std::uint64_t{0};  // ticks
  Counts from_{};                             // where the window began
  bool trouble_ = false;
};

}  // namespace fulcrum::app
