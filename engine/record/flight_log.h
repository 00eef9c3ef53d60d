#pragma once
// Keeps the ticks around the first fault that stopped the force, for flight.csv.

#include <cstdint>

#include "haptics/loop/flight_recorder.h"

namespace fulcrum::record {

class FlightLog {
public:
  static constexpr std::size_t kTicks = 2000;            // kept in all
  static constexpr std::int64_t kTicksAfterFault = 500;  // of these, how the force fell and what came of it

  void add(const FlightEntry& entry);

  // What is kept is all that there will be: from now on add() changes nothing.
  bool full() const { return left_ == 0; }
  bool fault_seen() const { return left_ <= kTicksAfterFault; }
  const FlightRecorder& ticks() const { return ticks_; }

private:
  FlightRecorder ticks_{kTicks};
  std::int64_t left_ = kTicksAfterFault + 1;  // ticks to keep from the one with the fault on
};

}  // namespace fulcrum::record
