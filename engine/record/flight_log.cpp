#include "engine/record/flight_log.h"

#include "haptics/safety/faults.h"

namespace fulcrum::record {

void FlightLog::add(const FlightEntry& entry) {
  if (full()) return;
  ticks_.push(entry);
  if (fault_seen() || (entry.record.faults & kStoppingFaults) != 0) --left_;
}

}  // namespace fulcrum::record
