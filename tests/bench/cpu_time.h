#pragma once
// Processor time, which a busy machine does not stretch as it does the clock on the wall.

#include <time.h>

#include <algorithm>
#include <vector>

namespace fulcrum::bench {

inline double cpu_s(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

// Of this thread, in microseconds.
template <class Work>
double cpu_us(const Work& work) {
  const double before = cpu_s(CLOCK_THREAD_CPUTIME_ID);
  work();
  return 1e6 * (cpu_s(CLOCK_THREAD_CPUTIME_ID) - before);
}

inline double quantile(std::vector<double> of, double share) {
  const auto at = of.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(of.size() - 1));
  std::nth_element(of.begin(), at, of.end());
  return *at;
}

}  // namespace fulcrum::bench
