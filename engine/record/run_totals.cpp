#include "engine/record/run_totals.h"

#include <algorithm>
#include <bit>

#include "haptics/safety/faults.h"

namespace fulcrum::record {

void RunTotals::WrenchTotals::add(const Wrench& wrench, double tick_s) {
  if (!wrench.is_finite()) return;
  const double force = wrench.force.norm();
  force_over_time += force * tick_s;
  peak_force = std::max(peak_force, force);
  peak_torque = std::max(peak_torque, wrench.torque.norm());
}

void RunTotals::add(const TickRecord& record) {
  ++ticks_;
  if (!record.stopped) {
    if (record.coupling_F_T_W.is_finite()) torque_error_ += record.coupling_F_T_W.torque.norm() * tick_s_;
    contact_.add(record.contact_F_T_W, tick_s_);
  }
  rendered_.add(record.device_F_H_D, tick_s_);
  for (std::uint32_t left = record.faults; left != 0; left &= left - 1) {
    BitCount& count = bits_[static_cast<std::size_t>(std::countr_zero(left))];
    if (count.ticks++ == 0) count.first_tick = record.tick;
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
    if ((fault.bit & mask) != 0 && count.ticks > 0)
      counts.push_back({fault.name, count.first_tick, count.ticks, fault.sentence});
  }
  return counts;
}

}  // namespace fulcrum::record
