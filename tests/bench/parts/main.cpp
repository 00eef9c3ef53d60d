// tools/bench parts: parts that fit into each other, in hands that are rough with them. --smoke: whether it
// works.

#include <cstdio>
#include <string_view>

#include "tests/bench/parts/parts_cost.h"

using namespace fulcrum;
using namespace fulcrum::bench;

int main(int argc, char** argv) {
  const bool smoke = argc > 1 && std::string_view(argv[1]) == "--smoke";
  std::printf("| parts | hand | reported (um) | judged (um) | tick p50 (us) | p99 (us) |\n");
  std::printf("| --- | --- | ---: | ---: | ---: | ---: |\n");
  std::size_t runs = 0;
  for (const parts::Fit& fit : parts::fits()) {
    const PartCost cost = cost_of(fit, smoke);
    std::printf("| **%s**, clearance %.0f um", fit.name.c_str(), 1e6 * fit.clearance);
    if (!cost.refused.empty()) {
      std::printf(" | refused | %s | | | |\n", cost.refused.c_str());
      continue;
    }
    std::printf(" | bake %.1f s, %.1f MB | | | | |\n", cost.bake_cpu_s, cost.MB);
    for (std::size_t i = 0; i < cost.runs.size(); ++i) {
      const PartCost::Run& run = cost.runs[i];
      std::printf("| | %s | %.1f | %.1f | %.1f | %.1f |\n", name_of(kPartHands[i]), 1e6 * run.reported,
                  1e6 * run.judged, run.median_us, run.p99_us);
    }
    std::fflush(stdout);
    runs += cost.runs.size();
  }
  return runs > 0 ? 0 : 1;
}
