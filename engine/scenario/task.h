#pragma once
// What a trainee is to do, as plain data.

#include <algorithm>
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

// To go in from a checkpoint's place, straight. The radius is that of the bore.
struct Insertion {
  Vec3 direction_W = -Vec3::UnitY();  // (3) unit
  double depth = 0.01;                // m, at which it is in
};

// To turn the tool at a checkpoint's place, against the clock seen from the axis' tip.
struct Turn {
  Vec3 axis_W = Vec3::UnitY();  // (3) unit
  double angle = 0;             // rad, above 0; in one go or in several
};

// To push the scene as hard as this, and no harder.
struct ForceRange {
  double least = 0, most = 0;  // N, of the scene on the tool
};

// To hold the tool so.
struct Facing {
  Quat q_WT = Quat::Identity();
  double within = 0.2;  // rad, of any rotation between the two
};

struct Checkpoint {
  std::string name;
  Vec3 position = Vec3::Zero();  // (3) m, in W
  double radius = 0.01;          // m
  std::string mirrored_name{};   // where the scene is mirrored; empty: the same
  Needs needs = Needs::place;
  std::string hint{};             // a sentence for whoever has it next, with hint words (hint.h); empty: none
  std::optional<double> dwell{};  // s; none: the task's
  // One of the two, or neither: what there is to go before the dwell counts.
  std::vector<Vec3> follow{};  // (n) m, in W: on from `position`, from corner to corner
  std::optional<Insertion> insert{};
  std::optional<Turn> turn{};
  // What has to be so all the while, beside `needs`.
  std::optional<ForceRange> force{};
  std::optional<Facing> facing{};
  bool optional = false;    // the task is completed without it, too
  std::string after{};      // the name of an earlier one, that has to be reached first; empty: none
  std::size_t written = 0;  // its place in the scenario's list, from 0, whatever a variant makes of that
};

// A ball that the touch point should stay out of.
struct Avoided {
  std::string name;
  Vec3 position = Vec3::Zero();  // (3) m, in W
  double radius = 0.01;          // m
};

enum class Order {
  given,  // each when those before it are reached, but for optional ones
  any     // each when the one that it comes `after` is
};

// The most points that a criterion has in a score.
struct ScoreWeights {
  double checkpoints = 40, optional = 0;  // the latter: those that need not be reached
  double time = 15, path = 15, force = 15, smoothness = 15, touches = 15;
  double hard_touches = 15, slips = 15, avoid = 15;  // where the task counts them
};

struct TaskDesc {
  std::vector<Checkpoint> checkpoints;
  double dwell = 3;                    // s, how long the touch point must stay at each without a break
  Vec3 touch_point = Vec3::Zero();     // p_TC (3) m, of the tool, in T
  std::string touch_name{};            // what the tool has there, "the needle's tip"; empty: it has no name
  std::optional<double> hard_touch{};  // N, of the scene on the tool: a touch that rises above it is counted
  Order order = Order::given;
  std::vector<Avoided> avoid{};
  ScoreWeights score{};
};

inline double dwell_of(const TaskDesc& task, const Checkpoint& checkpoint) {
  return checkpoint.dwell.value_or(task.dwell);
}

// Leaving it before it is done is a slip.
inline bool is_way(const Checkpoint& checkpoint) {
  return !checkpoint.follow.empty() || checkpoint.insert.has_value();
}

inline bool has_ways(const TaskDesc& task) {
  return std::ranges::any_of(task.checkpoints, is_way);
}

}  // namespace fulcrum::scenario

template <>
inline constexpr std::array<std::string_view, 3> fulcrum::names_of<fulcrum::scenario::Needs>{"place", "touch",
                                                                                             "stop"};
template <>
inline constexpr std::array<std::string_view, 2> fulcrum::names_of<fulcrum::scenario::Order>{"given", "any"};
