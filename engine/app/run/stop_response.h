#pragma once
// What a run without a person does about a stop by a fault: it ends, or, where faults were injected,
// acknowledges it after a second, and ends where that is of no avail.

#include <cstdint>

namespace fulcrum::app {

class StopResponse {
public:
  enum class Next { go_on, acknowledge, end };

  StopResponse(bool acknowledges, double tick_s);
  // After each tick. stopped: the force is, by a fault.
  Next after(bool stopped);

private:
  bool acknowledges_;
  std::int64_t ticks_per_second_;
  std::int64_t stopped_ = 0;  // ticks
};

}  // namespace fulcrum::app
