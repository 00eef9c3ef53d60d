#pragma once
// Faults that a run is given on purpose and that befall the program, not the device.

#include <sys/resource.h>

#include <filesystem>
#include <optional>
#include <vector>

#include "drivers/fault/injected_fault.h"

namespace fulcrum::app {

class ProgramFaults {
public:
  // Of faults, those that are not the device's. folder: where the run's files lie.
  ProgramFaults(const std::vector<InjectedFault>& faults, std::filesystem::path folder);
  ~ProgramFaults();  // files may grow again
  ProgramFaults(const ProgramFaults&) = delete;
  ProgramFaults& operator=(const ProgramFaults&) = delete;

  // Main thread, after each tick: what is due happens. time: s, of the ticks so far.
  void pass(double time);
  // The graphics card is gone.
  bool gpu_lost() const { return gpu_lost_; }

private:
  void fill_disk();

  std::vector<InjectedFault> waiting_;
  std::filesystem::path folder_;
  bool gpu_lost_ = false;
  std::optional<rlimit> limit_before_;  // of the files' sizes; set once the disk is full
};

}  // namespace fulcrum::app
