#include <algorithm>
#include <optional>
#include <string>

#include "engine/app/device_test/latency.h"
#include "engine/app/device_test/parts.h"
#include "haptics/math/number_text.h"

namespace fulcrum::app::device_test {
namespace {

constexpr double kKickGrows = 1;      // s, from nothing to the whole push
constexpr double kSlidesFrom = 3e-4;  // m: it slides from here on, and is pushed harder
constexpr double kAlong = 0.8;    // of where it has gone to by then, along the push: else that is another way
constexpr double kKick = 0.015;   // s at most, and
constexpr double kSpeed = 0.4;    // m/s that it gets at most, by the handle's mass
constexpr double kAfter = 0.08;   // s, in which what it does is seen
constexpr double kQuick_ms = 10;  // up to which a device is as one expects

// One push along an axis; sign: 1 there, -1 back. Absent: the handle did not give way, or went another way,
// as one with swapped motors does: nothing is pushed any longer then.
std::optional<Kick> kick_once(TestBench& bench, int axis, double sign) {
  const Vec3 way = sign * Vec3::Unit(axis);
  const double largest = bench.budget().force;
  const double lasts = std::min(kKick, kSpeed * bench.desc().handle_mass / largest);
  come_to_rest(bench);
  const BenchTick begun = bench.tick();
  Kick kick;
  double gone = 0;  // m, any way
  // One tick that pushes by a part of the largest.
  const auto tick = [&](double part) {
    const BenchTick& now = bench.tick({part * largest * way, Vec3::Zero()});
    const Vec3 moved = now.sample.X_DH.p - begun.sample.X_DH.p;
    gone = moved.norm();
    kick.time.push_back(now.time - begun.time);
    kick.commanded.push_back(now.commanded_F_H_D.force.dot(way));
    kick.moved.push_back(moved.dot(way));
  };
  tick(0);
  while (!bench.over() && kick.time.back() < kKickGrows && gone < kSlidesFrom)
    tick(kick.time.back() / kKickGrows);
  const bool slides = gone >= kSlidesFrom && kick.moved.back() >= kAlong * gone;
  kick.began = kick.time.back();
  if (slides) {
    while (!bench.over() && kick.time.back() - kick.began < lasts) tick(1);
    while (!bench.over() && kick.time.back() - kick.began < lasts + kAfter) tick(0);
  }
  come_to_rest(bench);
  if (bench.over() || !slides) return std::nullopt;
  return kick;
}

Part latency_part(TestBench& bench, Person& person) {
  Part part{.name = "latency"};
  if (answer_of(
          bench, person,
          "It is going to push shortly, with up to " + number_text(bench.budget().force, 3) +
              " N, right and left, up and down, near and far. Hold it loosely or let go of it. Go on?") ==
      Answer::no) {
    part.says = "Left out.";
    return part;
  }
  std::vector<double> found_ms;
  for (int axis = 0; axis < 3; ++axis)
    for (const double sign : {1.0, -1.0}) {
      if (bench.over()) break;
      const std::optional<Kick> kick = kick_once(bench, axis, sign);
      const std::optional<Latency> latency = kick ? latency_of(*kick) : std::nullopt;
      if (latency) found_ms.push_back(1e3 * latency->seconds);
    }
  if (bench.over()) {
    part.says = "It was not through when the test ended.";
    return part;
  }
  if (found_ms.empty()) {
    part.says =
        "The handle did not slide freely enough to tell it: it is held, its motors are off, or it went "
        "another way than it was pushed.";
    return part;
  }
  std::ranges::sort(found_ms);
  const double median = found_ms[found_ms.size() / 2];
  part.says = "What is commanded shows in a sample " + number_text(median, 2) +
              " ms later, in the median of " + std::to_string(found_ms.size()) + " pushes (" +
              number_text(found_ms.front(), 2) + " to " + number_text(found_ms.back(), 2) + " ms).";
  part.outcome = Outcome::good;
  if (median > kQuick_ms) {
    part.outcome = Outcome::odd;
    part.says += " Stiff walls need less: see `fulcrum doctor`, and use another USB port.";
  }
  part.measures = {{"median", median, "ms"},
                   {"smallest", found_ms.front(), "ms"},
                   {"largest", found_ms.back(), "ms"},
                   {"pushes that tell it", static_cast<double>(found_ms.size()), ""}};
  return part;
}

}  // namespace

void measure_latency(TestBench& bench, Person& person, Findings& findings) {
  if (bench.budget().force <= 0) return;
  findings.parts.push_back(latency_part(bench, person));
  person.tell(findings.parts.back().says);
}

}  // namespace fulcrum::app::device_test
