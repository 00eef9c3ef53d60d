#pragma once
// What a trainee is to do, as plain data.

#include <optional>
#include <string>
#include <vector>

#include "haptics/math/linear.h"

namespace fulcrum::scenario {

struct Checkpoint {
  std::string name;
  Vec3 position = Vec3::Zero();  // (3) m, in W
  double radius = 0.01;          // m
  std::string mirrored_name{};   // where the scene is mirrored; empty: the same
};

struct TaskDesc {
  std::vector<Checkpoint> checkpoints;  // in the order in which they are to be reached
  double dwell = 3;                     // s, how long the touch point must stay at each without a break
  Vec3 touch_point = Vec3::Zero();      // p_TC (3) m, of the tool, in T
  std::string touch_name{};             // what the tool has there, "the needle's tip"; empty: it has no name
  std::optional<double> hard_touch{};   // N, of the scene on the tool: a touch that rises above it is counted
};

}  // namespace fulcrum::scenario
