#include "engine/app/device_test/calibrate.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/app/device_test/parts.h"
#include "haptics/math/number_text.h"

namespace fulcrum::app::device_test {
namespace {

constexpr double kRampsIn = 0.6;       // s, after which the bench pushes as it is told
constexpr double kFollows = 0.5;       // of the way that it was led
constexpr double kSteady = 0.05;       // N, or
constexpr double kSteadyShare = 0.15;  // of the weight, by which weighings may differ
constexpr double kWhole = 0.95;        // of what the test may push with
constexpr double kEven = 0.02;         // N, by which a push may grow along its way

std::string millimetres(double metres) {
  return number_text(1e3 * metres, 3) + " mm";
}

// Where the handle was while the question was not answered.
struct Reached {
  Answer answer = Answer::no;
  Vec3 low_D = Vec3::Zero(), high_D = Vec3::Zero();  // (3) m
};

Reached follow(TestBench& bench, Person& person) {
  person.ask(
      "Move the handle as far as it goes: to the right and left, up and down, toward you and away. Done? n "
      "leaves this out.",
      Choice::yes_no);
  Reached reached;
  reached.low_D = reached.high_D = bench.tick().sample.X_DH.p;
  while (!bench.over()) {
    const Vec3 p_D = bench.tick().sample.X_DH.p;
    if (!bench.stopped()) {
      reached.low_D = reached.low_D.cwiseMin(p_D);
      reached.high_D = reached.high_D.cwiseMax(p_D);
    }
    if (const std::optional<Answer> answer = person.answer()) {
      reached.answer = *answer;
      break;
    }
  }
  return reached;
}

Part workspace_part(TestBench& bench, Person& person, scenario::Calibration& calibration) {
  Part part{.name = "workspace"};
  if (bench.budget().force <= 0) {
    part.says = "It has no motors that could tell where it ends.";
    return part;
  }
  if (!person.there()) {
    part.says = "Nobody was there to move the handle.";
    return part;
  }
  const Reached reached = follow(bench, person);
  if (reached.answer == Answer::no) {
    part.says = "Left out.";
    return part;
  }
  const Vec3& table = bench.desc().workspace;
  const Vec3 low_D = reached.low_D.cwiseMax(-table), high_D = reached.high_D.cwiseMin(table);
  const Vec3 half = (high_D - low_D) / 2;
  part.measures = {{"right and left", 2e3 * half.x(), "mm"},
                   {"up and down", 2e3 * half.y(), "mm"},
                   {"near and far", 2e3 * half.z(), "mm"}};
  if (half.minCoeff() < scenario::Calibration::kMinHalfExtent) {
    part.outcome = Outcome::bad;
    part.says = "Along one axis it went no farther than " + millimetres(2 * std::max(0.0, half.minCoeff())) +
                ": nothing is kept. Move it along all three, and see `fulcrum device-test`.";
    return part;
  }
  calibration.workspace = {(high_D + low_D) / 2, half};
  const Vec3 middle_D = calibration.workspace->centre_D;
  part.outcome = Outcome::good;
  part.says = "Its middle lies " + millimetres(middle_D.norm()) + " from the device's origin.";
  if ((reached.low_D.array() < low_D.array()).any() || (reached.high_D.array() > high_D.array()).any())
    part.says += " What lies outside of the workspace of its table is left out.";
  return part;
}

// What is wrong with a weighing; empty: nothing.
std::string why_no_weight(const Weighing& weighing, const TestBench& bench) {
  const std::string most = number_text(bench.budget().force, 3) + " N";
  if (weighing.astray || weighing.most > kWhole * bench.budget().force)
    return "it did not follow where it was led with up to " + most +
           ", and the force was let go: it weighs more than " + most +
           ", someone held it, or its axes are swapped or the wrong way round (`fulcrum device-test`).";
  if (weighing.moved < kFollows * kWeighingWay)
    return "it was led up and down by " + millimetres(kWeighingWay) + " and went " +
           millimetres(std::max(0.0, weighing.moved)) + ": it was held, lies on something, or rubs too much.";
  if (weighing.uneven > kEven)
    return "along its way it had to be pushed harder, by " + number_text(weighing.uneven, 2) +
           " N: it met something, such as the end of its workspace. Hold it in the middle before you let go "
           "of it.";
  const double steady = std::max(kSteady, kSteadyShare * std::abs(weighing.weight));
  if (weighing.spread > steady)
    return "weighed three times, it differed by " + number_text(weighing.spread, 2) + " N: someone held it.";
  return {};
}

Part weight_part(TestBench& bench, Person& person, scenario::Calibration& calibration) {
  Part part{.name = "weight"};
  if (bench.budget().force <= 0) {
    part.says = "It has no motors that could hold it up.";
    return part;
  }
  if (answer_of(bench, person,
                "The handle is going to hold itself up, with up to " + number_text(bench.budget().force, 3) +
                    " N, and go slowly up and down. Hold it in the middle of its workspace, answer, and let "
                    "it go. Go on?") == Answer::no) {
    part.says = "Left out.";
    return part;
  }
  const std::optional<Weighing> weighing = weigh(bench);
  if (!weighing) {
    part.says = "It was not through when the calibration ended.";
    return part;
  }
  if (!weighing->astray)
    part.measures = {{"weight", weighing->weight, "N"},
                     {"friction", weighing->friction, "N"},
                     {"differs by", weighing->spread, "N"},
                     {"went up and down", 1e3 * weighing->moved, "mm"}};
  if (const std::string why = why_no_weight(*weighing, bench); !why.empty()) {
    part.outcome = Outcome::bad;
    part.says = "Nothing is kept: " + why;
    return part;
  }
  calibration.handle_weight = std::clamp(weighing->weight, 0.0, scenario::max_handle_weight(bench.desc()));
  part.outcome = Outcome::good;
  part.says = "It is held up by " + number_text(*calibration.handle_weight, 3) + " N, and rubs with " +
              number_text(std::max(0.0, weighing->friction), 2) + " N.";
  return part;
}

// Whoever leaves out everything, answers everything with Enter or is gone changes nothing.
Part hand_part(TestBench& bench, Person& person, scenario::Calibration& calibration) {
  Part part{.name = "hand"};
  if (!person.there()) {
    part.says = "Nobody was there to say.";
    return part;
  }
  const std::string now = calibration.left_handed ? "left" : "right";
  const Answer hand = answer_of(
      bench, person, "Scenes are for the " + now + " hand. In which one do you hold it?", Choice::hand);
  if (bench.over()) return part;
  if (hand == Answer::left || hand == Answer::right) {
    calibration.left_handed = hand == Answer::left;
    part.outcome = Outcome::good;
  }
  part.says = calibration.left_handed ? "Left: scenes are mirrored (--set left_handed=false: not)."
                                      : "Right: scenes are as they were made.";
  return part;
}

}  // namespace

Findings calibrate(TestBench& bench, Person& person, scenario::Calibration& calibration) {
  Findings findings;
  const auto run = [&](auto part_of) {
    if (bench.over()) return;
    findings.parts.push_back(part_of(bench, person, calibration));
    person.tell(findings.parts.back().says);
  };
  pause(bench, kRampsIn);  // a handle that is let go later is held up at once
  run(workspace_part);
  run(weight_part);
  run(hand_part);
  end(bench, findings);
  return findings;
}

}  // namespace fulcrum::app::device_test
