#include "engine/app/run/stop_response.h"

#include <cmath>

namespace fulcrum::app {

StopResponse::StopResponse(bool acknowledges, double tick_s)
    : acknowledges_(acknowledges), ticks_per_second_(std::llround(1.0 / tick_s)) {}

StopResponse::Next StopResponse::after(bool stopped) {
  stopped_ = stopped ? stopped_ + 1 : 0;
  if (!stopped) return Next::go_on;
  if (!acknowledges_ || stopped_ >= 2 * ticks_per_second_) return Next::end;
  return stopped_ == ticks_per_second_ ? Next::acknowledge : Next::go_on;
}

}  // namespace fulcrum::app
