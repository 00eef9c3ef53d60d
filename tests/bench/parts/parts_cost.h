#pragma once
// Parts that fit into each other, in hands that are rough with them: what a run reports of their depth, what
// the triangles say, and what a tick costs.

#include <string>
#include <vector>

#include "tests/parts/fits.h"

namespace fulcrum::bench {

enum class PartHand { expert, sideways, lean, strike, jitter, spin, yank };
inline constexpr PartHand kPartHands[] = {PartHand::expert, PartHand::sideways, PartHand::lean,
                                          PartHand::strike, PartHand::jitter,   PartHand::spin,
                                          PartHand::yank};
const char* name_of(PartHand hand);

// What contact is measured on.
enum class Measured { points_in_a_field, triangles };

struct PartCost {
  std::string refused{};  // why it could not be baked or built; empty: it was
  double bake_cpu_s = 0, MB = 0;
  struct Run {
    double reported = 0, judged = 0;  // m, the deepest of any tick; judged: of those that were looked at
    double median_us = 0, p99_us = 0;
  };
  std::vector<Run> runs{};  // a hand each
};

// smoke: a few ticks of each, for a test that it works.
PartCost cost_of(const parts::Fit& fit, Measured measured, bool smoke);

}  // namespace fulcrum::bench
