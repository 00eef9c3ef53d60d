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
  // Integrals over time; a tick in which the wrench is not a number adds nothing, and the fault that came
  // with it tells of it. Of the coupling and of contact, a tick in which the force is stopped adds nothing
  // either: the trial's time rests then.
  double torque_error_Nms() const { return torque_error_; }  // of the coupling's torque on the tool
  // Of contact: what the scene does to the tool, about T; the tool's weight is no part of it.
  double force_error_Ns() const { return contact_.force_over_time; }
  double peak_force_N() const { return contact_.peak_force; }
  double peak_torque_Nm() const { return contact_.peak_torque; }
  // Rendered: what the motors were told, at the handle; 0 for a device without motors.
  double force_error_rendered_Ns() const { return rendered_.force_over_time; }
  double peak_force_rendered_N() const { return rendered_.peak_force; }
  double peak_torque_rendered_Nm() const { return rendered_.peak_torque; }

  std::vector<FaultCount> faults() const;  // bits that stop the force, those that occurred
  std::vector<FaultCount> limits() const;  // bits that do not

private:
  struct BitCount {
    std::int64_t first_tick = 0;
    std::int64_t ticks = 0;
  };
  struct WrenchTotals {
    double force_over_time = 0;  // N s
    double peak_force = 0;       // N
    double peak_torque = 0;      // N m
    void add(const Wrench& wrench, double tick_s);
  };
  std::vector<FaultCount> counts(std::uint32_t mask) const;

  double tick_s_;
  std::int64_t ticks_ = 0;
  double torque_error_ = 0;  // N m s
  WrenchTotals contact_, rendered_;
  std::array<BitCount, 32> bits_{};
};

}  // namespace fulcrum::record
