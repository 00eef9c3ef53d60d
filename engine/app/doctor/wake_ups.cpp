#include "engine/app/doctor/wake_ups.h"

#include <sys/mman.h>

#include <algorithm>
#include <chrono>
#include <thread>

#include "haptics/loop/real_time.h"

namespace fulcrum::app {

namespace {

constexpr std::chrono::milliseconds kEmptyTick{1};
constexpr int kEmptyTicks = 1000;

}  // namespace

WakeUps measure_wake_ups() {
  using Clock = std::chrono::steady_clock;
  WakeUps wake_ups;
  std::thread([&wake_ups] {
    wake_ups.scheduling = ask_for_scheduling(kHapticPriority);
    wake_ups.memory = ask_for_locked_memory();
    Clock::time_point due = Clock::now();
    for (int i = 0; i < kEmptyTicks; ++i) {
      due += kEmptyTick;
      std::this_thread::sleep_until(due);
      const Clock::duration late = Clock::now() - due;
      wake_ups.worst_s = std::max(wake_ups.worst_s, std::chrono::duration<double>(late).count());
      if (late >= kEmptyTick) ++wake_ups.late;
    }
  }).join();
  munlockall();
  return wake_ups;
}

}  // namespace fulcrum::app
