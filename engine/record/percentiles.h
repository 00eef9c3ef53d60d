#pragma once
// How long the ticks took.

#include <cstdint>
#include <span>

namespace fulcrum::record {

struct TickCpu {
  double p50 = 0, p99 = 0, p999 = 0, max = 0;  // us
};

// Nearest rank: the smallest time that at least this share of the ticks did not exceed. times: (ticks) ns,
// not empty; their order is lost.
TickCpu tick_cpu_percentiles(std::span<std::int64_t> times);

}  // namespace fulcrum::record
