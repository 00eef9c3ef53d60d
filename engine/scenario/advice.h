#pragma once
// What a scenario's author should know before anyone plays it: places that cannot be reached, a start in the
// scene, motions that no run will ever play. Found from what was read and baked; nothing here ticks.

#include <string>
#include <vector>

#include "engine/scenario/assemble.h"

namespace fulcrum::scenario {

enum class Severity {
  note,     // worth knowing
  warning,  // worth a thought: it runs, and may not do what its author wants
  error     // no run can go well
};

struct Advice {
  std::string key;       // what it is about, a dotted path: "checkpoints.0.position"
  std::string sentence;  // what is there, and the cure
  Severity severity = Severity::warning;
};

// A checkpoint is said to be out of reach where none of the poses that are tried, 7 places for each of some
// 25 orientations, keeps the tool out of the scene: a search, not a proof, and not of the way there.
std::vector<Advice> advise(const HapticAssembly& assembly);

}  // namespace fulcrum::scenario
