#include <algorithm>
#include <limits>

#include "engine/analysis/hardness/report.h"
#include "engine/analysis/hardness/tables.h"
#include "engine/analysis/hardness/words.h"

namespace fulcrum::analysis::hardness {
namespace {

using report::short_number;

constexpr double kRounding = 1e-9;  // what rounding leaves

std::string times(double gain) {
  return number(gain) + " times";
}

// "1.4 to 2.1 times", over the poses that can be reached.
std::string over_poses(const HardnessStudy& study, Gain PoseAt::*gain) {
  double least = std::numeric_limits<double>::infinity(), most = 0;
  for (const PoseAt& pose : study.poses) {
    if (!pose.reached) continue;
    least = std::min(least, (pose.*gain).moment);
    most = std::max(most, (pose.*gain).moment);
  }
  return number(least) + " to " + times(most);
}

template <class Row>
Row of_method(const std::vector<Row>& rows, PulseMethod method) {
  for (const Row& row : rows)
    if (row.method == method) return row;
  return {};
}

}  // namespace

std::vector<std::string> hardness_answer(const HardnessStudy& study) {
  std::vector<std::string> answer;
  const StrikeSetting& s = study.setting;
  const auto by = [&study](PulseMethod method) { return of_method(study.means, method); };
  const DirectionMeans force = by(PulseMethod::force_only), spare = by(PulseMethod::force_only_spare),
                       algorithm1 = by(PulseMethod::algorithm1), exact = by(PulseMethod::exact);
  const double enough = force.force * s.ticks * s.tick_s / s.hand_mass;
  answer.push_back("To stop " + number(s.hand_mass) + " kg at " + number(s.speed) +
                   " m/s in one tick takes " + number(s.wanted_force()) + " N. " + study.title + " has " +
                   number(force.force) + " N: from " + short_number(enough, 2) +
                   " m/s on force is missing. (Means over directions, as below; φ, the angle between the "
                   "surface's normal and the stylus, is 45°.)");
  if (!study.renders_torque) {
    answer.push_back(
        "It renders no torque. No moment can stand in for the missing force, in no direction, at no "
        "angle and in no pose: every method gives the force alone.");
    return answer;
  }
  answer.push_back("Algorithm 1 finds a moment in " + percent(algorithm1.helped) + " of the directions" +
                   (algorithm1.helped < 1 - kRounding ? " and none in the others" : "") +
                   ". The felt moment becomes " + times(algorithm1.gain) +
                   " that of the force alone, at most " + times(algorithm1.largest_gain) +
                   "; the force stays.");
  answer.push_back(
      "The exact method gives more felt moment in " + percent(exact.helped) + " of the directions" +
      (exact.lowered > 0 ? " and less in " + percent(exact.lowered) : std::string()) + ": " +
      times(exact.gain) + ", at most " + times(exact.largest_gain) + ", with " + number(exact.force) +
      " N of force." +
      (spare.gain > 1 + kNoticed ? " A part of that, " + times(spare.gain) +
                                       " in force and moment, takes no moment: it comes of motors to spare."
                                 : ""));
  if (!study.along_stylus.empty()) {
    const DirectionMeans own = of_method(study.along_stylus, PulseMethod::algorithm1),
                         own_exact = of_method(study.along_stylus, PulseMethod::exact);
    answer.push_back(
        "That is a stylus which turns with each surface. With the grasp where this device has its own, on "
        "the line between the arms' ends, Algorithm 1 finds a moment in " +
        number(100 * own.helped) + " % of the directions, and the exact method gives " +
        times(own_exact.gain) + " the felt moment.");
  }
  const auto in_tick = [&study](PulseMethod method) {
    return of_method(study.in_the_tick, method).gain.moment;
  };
  answer.push_back("In a tick the whole is held to " + number(study.max_force) + " N and " +
                   number(study.max_torque) + " N m, which leaves " +
                   times(in_tick(PulseMethod::algorithm1)) + " and " + times(in_tick(PulseMethod::exact)) +
                   ".");
  answer.push_back("Over the workspace the mean gain is " + over_poses(study, &PoseAt::algorithm1) +
                   " by Algorithm 1, " + over_poses(study, &PoseAt::exact) + " by the exact method.");
  answer.push_back(
      "Where it cannot: at φ = 0, where a contact has no moment at the grasp; for strikes that the "
      "motors can stop; and by Algorithm 1 wherever the moment needs more of the motor that the force "
      "has saturated.");
  return answer;
}

}  // namespace fulcrum::analysis::hardness
