#include <algorithm>
#include <cmath>

#include "engine/app/device_test/parts.h"
#include "haptics/math/number_text.h"

namespace fulcrum::app::device_test {
namespace {

constexpr double kGrows = 1;        // s, from nothing to the whole push
constexpr double kLasts = 1.5;      // s
constexpr double kGivesWay = 5e-3;  // m, and
constexpr double kGivesTurn = 0.1;  // rad: a push ends there
constexpr double kMoved = 3e-4;     // m, and
constexpr double kTurned = 0.01;    // rad: less is no answer to a push

struct Pushed {
  double along = 0, across = 0;  // m or rad, when it ended
  double most = 0;               // N or N m that were commanded
  double step = 0;               // m or rad, the smallest change that was seen; 0: none
};

// sign: 1 there, -1 back.
Pushed push_once(TestBench& bench, int axis, double sign, Findings& findings) {
  const bool turns = axis >= 3;
  const Vec3 way = sign * Vec3::Unit(axis % 3);
  const double largest = turns ? bench.budget().torque : bench.budget().force;
  come_to_rest(bench);
  const BenchTick begun = bench.tick();
  PushTrace trace{.name = sign > 0 ? way_of(axis).there : way_of(axis).back, .turns = turns};
  Pushed pushed;
  Vec3 last = Vec3::Zero();
  double time = 0;
  while (!bench.over() && time < kLasts) {
    const Vec3 wanted = std::min(1.0, time / kGrows) * largest * way;
    const BenchTick& now = bench.tick(turns ? Wrench{Vec3::Zero(), wanted} : Wrench{wanted, Vec3::Zero()});
    time = now.time - begun.time;
    const Vec6 all = way_between(begun.sample.X_DH, now.sample.X_DH);
    const Vec3 moved = turns ? all.tail<3>() : all.head<3>();
    const Wrench& F = now.commanded_F_H_D;
    trace.time.push_back(time);
    trace.commanded.push_back((turns ? F.torque : F.force).dot(way));
    trace.moved.push_back(moved.dot(way));
    pushed.most = std::max(pushed.most, (turns ? F.torque : F.force).norm());
    const double change = std::abs((moved - last).dot(way));
    if (change > 1e-9 && (pushed.step == 0 || change < pushed.step)) pushed.step = change;
    last = moved;
    pushed.along = moved.dot(way);
    pushed.across = (moved - pushed.along * way).norm();
    if (moved.norm() > (turns ? kGivesTurn : kGivesWay)) break;
  }
  findings.pushes.push_back(std::move(trace));
  come_to_rest(bench);
  return pushed;
}

enum class Gave { way, nothing, against, across };

Gave gave(const Pushed& pushed, bool turns) {
  const double least = turns ? kTurned : kMoved;
  if (pushed.across > least && pushed.across > std::abs(pushed.along)) return Gave::across;
  if (std::abs(pushed.along) <= least) return Gave::nothing;
  return pushed.along > 0 ? Gave::way : Gave::against;
}

// What the handle did. A hand that holds it may pull anywhere, and knows better.
void judge(Part& part, Gave there, Gave back, const std::optional<Answer>& felt) {
  const auto one_is = [&](Gave what) { return there == what || back == what; };
  part.outcome = Outcome::good;
  if (one_is(Gave::across)) {
    part.outcome = Outcome::bad;
    part.says = "The handle went across the push: its axes or motors are swapped.";
  } else if (one_is(Gave::against)) {
    part.outcome = Outcome::bad;
    part.says = "The handle went against the push: this axis of its motors is the wrong way round.";
  } else if (one_is(Gave::nothing)) {
    part.outcome = Outcome::odd;
    part.says = "The handle did not give way: it is held, or its motors are off.";
  } else {
    part.says = "The handle gave way along the push, there and back.";
  }
  if (!felt) return;
  if (*felt == Answer::no) {
    part.outcome = Outcome::bad;
    part.says += " It was not felt.";
    return;
  }
  part.outcome = part.outcome == Outcome::bad ? Outcome::odd : Outcome::good;
  part.says += " It was felt as it should be.";
}

Part push_axis(TestBench& bench, Person& person, int axis, Findings& findings) {
  const bool turns = axis >= 3;
  const Way& way = way_of(axis);
  const std::string ways = std::string(way.there) + ", then " + way.back;
  Part part{.name = std::string(turns ? "twist, " : "push ") + way.both};
  const std::string most =
      turns ? number_text(bench.budget().torque, 3) + " N m" : number_text(bench.budget().force, 3) + " N";
  if (answer_of(bench, person,
                "It is going to " + std::string(turns ? "turn " : "push ") + ways + ", with up to " + most +
                    ". Hold it loosely. Go on?") == Answer::no) {
    part.says = "Left out.";
    return part;
  }
  const Pushed there = push_once(bench, axis, 1, findings), back = push_once(bench, axis, -1, findings);
  if (bench.over()) {
    part.says = "It was not through when the test ended.";
    return part;
  }
  std::optional<Answer> felt;
  if (person.there()) felt = answer_of(bench, person, "Did it go " + ways + "?");
  judge(part, gave(there, turns), gave(back, turns), felt);
  constexpr double to_small = 1e3;
  const char* const unit = turns ? "mrad" : "mm";
  part.measures = {{"most", std::max(there.most, back.most), turns ? "N m" : "N"},
                   {"moved there", to_small * there.along, unit},
                   {"moved back", to_small * back.along, unit},
                   {"across", to_small * std::max(there.across, back.across), unit}};
  if (there.step > 0) part.measures.push_back({"smallest step seen", to_small * there.step, unit});
  return part;
}

}  // namespace

void push(TestBench& bench, Person& person, Findings& findings) {
  const PushBudget& budget = bench.budget();
  if (budget.force <= 0 && budget.torque <= 0) {
    findings.parts.push_back({"push", Outcome::unknown, "It has no motors that push."});
    return;
  }
  for (int axis = 0; axis < 6 && !bench.over(); ++axis) {
    if ((axis < 3 ? budget.force : budget.torque) <= 0) continue;
    findings.parts.push_back(push_axis(bench, person, axis, findings));
    person.tell(findings.parts.back().says);
  }
}

}  // namespace fulcrum::app::device_test
