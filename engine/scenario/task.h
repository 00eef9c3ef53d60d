#pragma once
// What a trainee is to do, as plain data.

#include <optional>
#include <string>
#include <vector>

#include "haptics/math/linear.h"
#include "haptics/math/names_of.h"

namespace fulcrum::scenario {

// What a checkpoint needs beside the touch point's being there.
enum class Needs {
  place,  // nothing
  touch,  // that the tool touches the scene all the while
  stop    // that the force was stopped there, as Esc does, and taken up again
};

struct Checkpoint {
  std::string name;
  Vec3 position = Vec3::Zero();  // (3) m, in W
  double radius = 0.01;          // m
  std::string mirrored_name{};   // where the scene is mirrored; empty: the same
  Needs needs = Needs::place;
  std::string hint{};  // a sentence for whoever has it next, with hint words (hint.h); empty: none
};

struct TaskDesc {
  std::vector<Checkpoint> checkpoints;  // in the order in which they are to be reached
  double dwell = 3;                     // s, how long the touch point must stay at each without a break
  Vec3 touch_point = Vec3::Zero();      // p_TC (3) m, of the tool, in T
  std::string touch_name{};             // what the tool has there, "the needle's tip"; empty: it has no name
  std::optional<double> hard_touch{};   // N, of the scene on the tool: a touch that rises above it is counted
};

}  // namespace fulcrum::scenario

template <>
inline constexpr std::array<std::string_view, 3> fulcrum::names_of<fulcrum::scenario::Needs>{"place", "touch",
                                                                                             "stop"};
