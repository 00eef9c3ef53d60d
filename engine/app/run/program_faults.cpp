#include "engine/app/run/program_faults.h"

#include <algorithm>
#include <csignal>
#include <iterator>
#include <system_error>
#include <utility>

namespace fulcrum::app {
namespace {

rlimit file_limit() {
  rlimit limit{};
  getrlimit(RLIMIT_FSIZE, &limit);
  return limit;
}

}  // namespace

ProgramFaults::ProgramFaults(const std::vector<InjectedFault>& faults, std::filesystem::path folder)
    : folder_(std::move(folder)) {
  std::ranges::copy_if(
      faults, std::back_inserter(waiting_),
      [](const InjectedFault& fault) { return !is_of_device(fault.kind); });
}

ProgramFaults::~ProgramFaults() {
  if (limit_before_) setrlimit(RLIMIT_FSIZE, &*limit_before_);
}

void ProgramFaults::pass(double time) {
  std::erase_if(
      waiting_,
      [&](const InjectedFault& fault) {
        if (time < fault.at) return false;
        if (fault.kind == Injection::kill) std::raise(SIGKILL);
        if (fault.kind == Injection::gpu_lost) gpu_lost_ = true;
        if (fault.kind == Injection::disk_full) fill_disk();
        return true;
      });
}

// The largest of the run's files can no longer grow, which is how a full disk looks from here: writing fails.
// What is smaller may still be written.
void ProgramFaults::fill_disk() {
  std::uintmax_t largest = 0;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder_, none))
    if (const std::uintmax_t size = entry.file_size(none); !none) largest = std::max(largest, size);
  rlimit limit = file_limit();
  if (!limit_before_) limit_before_ = limit;
  limit.rlim_cur = std::min<rlim_t>(largest, limit.rlim_cur);
  setrlimit(RLIMIT_FSIZE, &limit);
}

}  // namespace fulcrum::app
