#pragma once
// The clock by which everything that grows old is told how old it is: samples, commands, ticks that are late.
// It goes on while the machine is suspended, as std::chrono::steady_clock does not on Linux: after a laptop's
// lid was shut for an hour a sample is an hour old, and the tick is an hour late.

#include <time.h>

#include <chrono>
#include <cstdint>

namespace fulcrum {

struct AgeClock {
  using rep = std::int64_t;
  using period = std::nano;
  using duration = std::chrono::nanoseconds;
  using time_point = std::chrono::time_point<AgeClock>;
  static constexpr bool is_steady = true;
  static constexpr clockid_t kId = CLOCK_BOOTTIME;

  static time_point now() noexcept {
    timespec now{};
    clock_gettime(kId, &now);
    return time_point(std::chrono::seconds(now.tv_sec) + std::chrono::nanoseconds(now.tv_nsec));
  }
  static std::int64_t now_ns() noexcept { return now().time_since_epoch().count(); }
};

}  // namespace fulcrum
