#include "engine/record/run_totals.h"

#include <algorithm>
#include <bit>

#include "haptics/safety/faults.h"

namespace fulcrum::record {

void RunTotals::add(const TickRecord& record) {
  ++ticks_;
  if (record.coupling_F_T_W.is_finite()) {
    torque_error_ += record.coupling_F_T_W.torque.norm() * tick_s_;
    force_error_ += record.coupling_F_T_W.force.norm() * tick_s_;
  }
  // max() keeps the peak where the norm is not a number: every comparison with NaN is false.
  peak_force_ = std::max(peak_force_, record.device_F_H_D.force.norm());
  peak_torque_ = std::max(peak_torque_, record.device_F_H_D.torque.norm());
  for (std::uint32_t left = record.faults; left != 0; left &= left - 1) {
    BitCount& count = bits_[static_cast<std::size_t>(std::countr_zero(left))];
    if (count.ticks++ == 0) {
      count.first_tick = record.tick;
    }
  }
}

std::vector<FaultCount> RunTotals::faults() const {
  return counts(kStoppingFaults);
}

std::vector<FaultCount> RunTotals::limits() const {
  return counts(~kStoppingFaults);
}

std::vector<FaultCount> RunTotals::counts(std::uint32_t mask) const {
  std::vector<FaultCount> counts;
  for (const FaultName& fault : fault_names()) {
    const BitCount& count = bits_[static_cast<std::size_t>(std::countr_zero(std::uint32_t{fault.bit}))];
    if ((fault.bit & mask) != 0 && count.ticks > 0) {
      counts.push_back({fault.name, count.first_tick, count.ticks, fault.sentence});
    }
  }
  return counts;
}

}  // namespace fulcrum::record
