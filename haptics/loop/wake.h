#pragma once
// What a haptic thread finds when it wakes: how late it is, and what of that is made up for.

#include <algorithm>
#include <cstdint>

namespace fulcrum {

inline constexpr int kCatchUp = 5;  // ticks run at most after a gap; the rest are lost
// ns. Desktops take the processor away for tens of ms: that is a late tick, whose held force has decayed.
// Past this the thread has hung, or the machine was suspended, and the person may have gone on to something
// else: the force stops until acknowledged.
inline constexpr std::int64_t kLongStall_ns = 250'000'000;

struct Wake {
  std::int64_t late_ns = 0;  // after the deadline
  std::int64_t due = 1;      // ticks, with the one of the deadline
  std::int64_t lost = 0;     // of these, that are not run
  bool long_stall = false;   // all force is to stop
};

// now_ns, deadline_ns: by a clock that goes on whatever holds the thread up.
constexpr Wake wake_at(std::int64_t now_ns, std::int64_t deadline_ns, std::int64_t tick_ns) noexcept {
  Wake wake;
  wake.late_ns = std::max<std::int64_t>(now_ns - deadline_ns, 0);
  wake.due = 1 + wake.late_ns / tick_ns;
  wake.lost = std::max<std::int64_t>(wake.due - kCatchUp, 0);
  wake.long_stall = wake.late_ns >= kLongStall_ns;
  return wake;
}

}  // namespace fulcrum
