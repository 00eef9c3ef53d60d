#include "tests/person/plans.h"

#include <algorithm>

namespace fulcrum::person {
namespace {

constexpr Place kFree{}, kOver{0, -0.075};

const std::vector<Plan> kPlans = {
    {"plate", '2', 0.05, std::vector<Place>(7, kFree)},
    // From above: from tooth to tooth well over the cusps, and down at the place.
    {"teeth", '2', 0.15, std::vector<Place>(6, kFree)},
    {"stick", 0, 0, std::vector<Place>(6, kFree)},
    {"sweep", 0, 0, std::vector<Place>(7, kFree)},
    // The row is outside the corridor: over the pegs at its side.
    {"knock", 0, 0, {kFree, kFree, kFree, kFree, kFree, kFree, kOver, kFree}},
};

}  // namespace

const Plan* find_plan(const std::string& scene) {
  const auto found = std::ranges::find(kPlans, scene, &Plan::scene);
  return found == kPlans.end() ? nullptr : &*found;
}

}  // namespace fulcrum::person
