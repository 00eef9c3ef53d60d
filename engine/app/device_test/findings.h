#pragma once
// What a device test has found, as plain data.

#include <array>
#include <string>
#include <vector>

#include "haptics/math/names_of.h"

namespace fulcrum::app::device_test {

enum class Outcome {
  good,
  odd,     // it works, and something about it is not as its table has it
  bad,     // it does not do what it should
  unknown  // it was left out, or nobody was there who could tell
};

struct Measure {
  std::string name;
  double value = 0;
  std::string unit;
};

struct Part {
  std::string name;  // what was tested: "samples", "push right and left", ...
  Outcome outcome = Outcome::unknown;
  std::string says{};  // a sentence or two
  std::vector<Measure> measures{};
};

// One push, tick by tick.
struct PushTrace {
  std::string name;  // the way it went
  bool turns = false;
  std::vector<double> time{};       // s, since it began
  std::vector<double> commanded{};  // N, or N m; that way
  std::vector<double> moved{};      // m, or rad; that way
};

struct Findings {
  std::vector<Part> parts;
  std::vector<PushTrace> pushes;
  std::vector<double> ages;  // s, of the samples while it rested
};

}  // namespace fulcrum::app::device_test

namespace fulcrum {
template <>
inline constexpr std::array<std::string_view, 4> names_of<app::device_test::Outcome>{"good", "odd", "bad",
                                                                                     "unknown"};
}  // namespace fulcrum
