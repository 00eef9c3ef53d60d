#include <array>

#include "engine/app/device_test/parts.h"
#include "haptics/math/rotation.h"

namespace fulcrum::app::device_test {
namespace {

constexpr double kLongestRest = 2;   // s
constexpr double kStill = 0.1;       // s in which a handle at rest moves by less than
constexpr double kStillWay = 2e-4;   // m
constexpr double kStillTurn = 5e-3;  // rad
constexpr double kLastTicks = 0.02;  // s of no force at the end

}  // namespace

Findings walk(TestBench& bench, Person& person) {
  Findings findings;
  for (const auto part : {&listen, &follow_hand, &follow_buttons, &push, &measure_latency, &vibrate})
    if (!bench.over()) part(bench, person, findings);
  end(bench, findings);
  return findings;
}

void end(TestBench& bench, Findings& findings) {
  if (bench.stopped())
    findings.parts.push_back({"the end", Outcome::bad,
                              "The force was stopped, and with it the test. " + bench.why_stopped() +
                                  " See that the device is plugged in and switched on, and begin again."});
  else if (bench.over())
    findings.parts.push_back({"the end", Outcome::unknown, "The test was ended before it was through."});
  for (double time = 0; time < kLastTicks; time += bench.tick_s()) bench.tick();
}

const Way& way_of(int axis) {
  static constexpr std::array<Way, 6> kWays{
      {{"right", "left", "right and left"},
       {"up", "down", "up and down"},
       {"toward you", "away from you", "near and far"},
       {"top toward you", "top away from you", "tilting"},
       {"anticlockwise from above", "clockwise from above", "turning"},
       {"anticlockwise as you see it", "clockwise as you see it", "rolling"}}};
  return kWays[static_cast<std::size_t>(axis)];
}

Answer answer_of(TestBench& bench, Person& person, std::string_view question, Choice choice) {
  person.ask(question, choice);
  while (!bench.over()) {
    bench.tick();
    if (const std::optional<Answer> answer = person.answer()) return *answer;
  }
  return Answer::no;
}

void pause(TestBench& bench, double seconds) {
  const double begun = bench.tick().time;
  while (!bench.over() && bench.tick().time - begun < seconds) {
  }
}

void come_to_rest(TestBench& bench) {
  BenchTick from = bench.tick();
  const double begun = from.time;
  while (!bench.over()) {
    const BenchTick& now = bench.tick();
    const Vec6 way = way_between(from.sample.X_DH, now.sample.X_DH);
    const bool still = way.head<3>().norm() < kStillWay && way.tail<3>().norm() < kStillTurn;
    if (still && now.time - from.time >= kStill) return;
    if (!still) from = now;
    if (now.time - begun > kLongestRest) return;
  }
}

Vec6 way_between(const Pose& from, const Pose& to) {
  Vec6 way;
  way << to.p - from.p, rotation_vector(to.q * from.q.conjugate());
  return way;
}

}  // namespace fulcrum::app::device_test
