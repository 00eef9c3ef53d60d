#include "tests/person/plans.h"

#include <algorithm>

namespace fulcrum::person {
namespace {

const Leg kFree{}, kOver{.detour = {0, -0.075}}, kTouch{.detour = {}, .touches = true};

const std::vector<Plan> kPlans = {
    {"tutorial",
     '2',
     0.2,
     {kFree, {.detour = {}, .roll = 0.42}, kTouch, kTouch, kTouch, {.detour = {}, .stops = true}}},
    {"plate", '2', 0.05, std::vector<Leg>(7, kFree)},
    // From above: from tooth to tooth well over the cusps, and down at the place.
    {"teeth", '2', 0.15, std::vector<Leg>(6, kFree)},
    {"stick", 0, 0, std::vector<Leg>(6, kFree)},
    {"sweep", 0, 0, std::vector<Leg>(7, kFree)},
    // The row is outside the corridor: over the pegs at its side.
    {"knock", 0, 0, {kFree, kFree, kFree, kFree, kFree, kFree, kOver, kFree}},
};

}  // namespace

const Plan* find_plan(const std::string& scene) {
  const auto found = std::ranges::find(kPlans, scene, &Plan::scene);
  return found == kPlans.end() ? nullptr : &*found;
}

}  // namespace fulcrum::person
