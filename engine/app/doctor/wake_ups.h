#pragma once
// How late a thread wakes that is scheduled as the haptic one is.

#include "engine/app/doctor/finding.h"

namespace fulcrum::app {

// A second of ticks of 1 kHz with nothing in them. scheduling, memory: what the system said when it was asked
// (haptics/loop/real_time.h), empty where it granted them.
struct WakeUps {
  double worst_s = 0;
  int late = 0;  // of a thousand, those that came a tick or more too late
  std::string scheduling, memory;
};
WakeUps measure_wake_ups();

}  // namespace fulcrum::app
