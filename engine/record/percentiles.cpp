#include "engine/record/percentiles.h"

#include <algorithm>
#include <cstddef>

namespace fulcrum::record {

TickCpu tick_cpu_percentiles(std::span<std::int64_t> times) {
  std::sort(times.begin(), times.end());
  // Shares in per mille, so that the rank is exact: 0.99 * 100 in doubles is not always 99.
  const auto at = [&times](std::size_t per_mille) {
    const std::size_t rank = (times.size() * per_mille + 999) / 1000;
    return static_cast<double>(times[rank - 1]) / 1000;
  };
  return {at(500), at(990), at(999), at(1000)};
}

}  // namespace fulcrum::record
