#pragma once

#include <algorithm>

#include "haptics/loop/run_tick.h"

namespace fulcrum::analysis {

// us of processor time that work() takes: the least of a few runs, since other programs on the machine only
// ever add to it.
template <class Work>
double best_us(const Work& work) {
  constexpr int runs = 5;
  double best = 0;
  for (int run = 0; run < runs; ++run) {
    const std::int64_t before = thread_cpu_ns();
    work();
    const double us = static_cast<double>(thread_cpu_ns() - before) * 1e-3;
    best = run == 0 ? us : std::min(best, us);
  }
  return best;
}

}  // namespace fulcrum::analysis
