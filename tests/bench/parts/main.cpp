// tools/bench parts [--smoke] [NAME]: parts that fit into each other, in hands that are rough with them, with
// contact measured on points in a distance field and on the triangles. --smoke: whether it works. NAME: of
// those alone in whose name it is.

#include <cstdio>
#include <string_view>

#include "tests/bench/parts/parts_cost.h"

using namespace fulcrum;
using namespace fulcrum::bench;

namespace {

// How many runs there were.
std::size_t print(Measured measured, const PartCost& cost) {
  std::printf("| | **%s** ", measured == Measured::triangles ? "triangles" : "points");
  if (!cost.refused.empty()) {
    std::printf("refused: %s | | | | |\n", cost.refused.c_str());
    return 0;
  }
  std::printf("bake %.1f s, %.1f MB | | | | |\n", cost.bake_cpu_s, cost.MB);
  for (std::size_t i = 0; i < cost.runs.size(); ++i) {
    const PartCost::Run& run = cost.runs[i];
    std::printf("| | %s | %.1f | %.1f | %.1f | %.1f |\n", name_of(kPartHands[i]), 1e6 * run.reported,
                1e6 * run.judged, run.median_us, run.p99_us);
  }
  std::fflush(stdout);
  return cost.runs.size();
}

}  // namespace

int main(int argc, char** argv) {
  const bool smoke = argc > 1 && std::string_view(argv[1]) == "--smoke";
  const std::string_view wanted = argc > (smoke ? 2 : 1) ? argv[smoke ? 2 : 1] : "";
  std::printf("| parts | measured on, hand | reported (um) | judged (um) | tick p50 (us) | p99 (us) |\n");
  std::printf("| --- | --- | ---: | ---: | ---: | ---: |\n");
  std::size_t runs = 0;
  for (const parts::Fit& fit : parts::fits()) {
    if (fit.name.find(wanted) == std::string::npos) continue;
    std::printf("| **%s**, clearance %.0f um | | | | | |\n", fit.name.c_str(), 1e6 * fit.clearance);
    for (const Measured measured : {Measured::points_in_a_field, Measured::triangles})
      runs += print(measured, cost_of(fit, measured, smoke));
  }
  return runs > 0 ? 0 : 1;
}
