#include "engine/app/device_test/pace.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <thread>

namespace fulcrum::app::device_test {

Pace without_clock(double tick_s) {
  return [tick_s, tick = std::int64_t{0}]() mutable { return static_cast<double>(tick++) * tick_s; };
}

Pace by_clock(double tick_s) {
  using Clock = std::chrono::steady_clock;
  return [tick_s, began = Clock::now(), tick = std::int64_t{-1}]() mutable {
    const std::chrono::duration<double> now = Clock::now() - began;
    tick = std::max(tick + 1, static_cast<std::int64_t>(std::floor(now.count() / tick_s)));
    const std::chrono::duration<double> due(static_cast<double>(tick) * tick_s);
    std::this_thread::sleep_until(began + std::chrono::duration_cast<Clock::duration>(due));
    return std::chrono::duration<double>(Clock::now() - began).count();
  };
}

}  // namespace fulcrum::app::device_test
