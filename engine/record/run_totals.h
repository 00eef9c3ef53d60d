#pragma once
// What summary.json says about all ticks together, added up one record at a time.

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "haptics/world/tick_record.h"

namespace fulcrum::record {

struct FaultCount {
  std::string name;             // as in faults.h
  std::int64_t first_tick = 0;  // in which it was set
  std::int64_t ticks = 0;       // in which it was set
  std::string sentence;
};

class RunTotals {
public:
  explicit RunTotals(double tick_s) : tick_s_(tick_s) {}

  void add(const TickRecord& record);

  std::int64_t ticks() const { return ticks_; }
  // Integrals of the coupling's wrench on the tool over time; a tick in which it is not a number adds
  // nothing, and the fault that came with it tells of it.
  double torque_error_Nms() const { return torque_error_; }
  double force_error_Ns() const { return force_error_; }
  // Of the wrench commanded to the device.
  double peak_force_N() const { return peak_force_; }
  double peak_torque_Nm() const { return peak_torque_; }

  std::vector<FaultCount> faults() const;  // bits that stop the force, those that occurred
  std::vector<FaultCount> limits() const;  // bits that do not

private:
  struct BitCount {
    std::int64_t first_tick = 0;
    std::int64_t ticks = 0;
  };
  std::vector<FaultCount> counts(std::uint32_t mask) const;

  double tick_s_;
  std::int64_t ticks_ = 0;
  double torque_error_ = 0, force_error_ = 0;  // N m s, N s
  double peak_force_ = 0, peak_torque_ = 0;    // N, N m
  std::array<BitCount, 32> bits_{};
};

}  // namespace fulcrum::record
