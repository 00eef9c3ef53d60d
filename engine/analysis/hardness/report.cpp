#include "engine/analysis/hardness/report.h"

#include <algorithm>
#include <cmath>

#include "engine/analysis/hardness/figures.h"
#include "engine/analysis/hardness/tables.h"
#include "engine/analysis/hardness/words.h"

namespace fulcrum::analysis::hardness {
namespace {

using report::short_number;

constexpr double kRoundingLeft = 1e-9;  // what rounding leaves

// Of the sides to which a stylus can lean at a surface that faces up: where Algorithm 1 finds no moment.
double leans_without(const HardnessStudy& study) {
  double without = 0;
  for (const TiltSample& at : study.leans)
    if (at.algorithm1.moment_D.norm() <= (1 + kNoticed) * at.force_only.moment_D.norm()) ++without;
  return without / static_cast<double>(study.leans.size());
}

void say_answer(report::Page& page, const HardnessStudy& study) {
  page.command(study.command);
  for (const std::string& sentence : hardness_answer(study)) page.paragraph(sentence);
  page.note(
      "Nothing here is a finding about people. What a hand would feel is worked out from forces and "
      "moments. That a larger moment is felt as a harder surface is what one study found, on one device, "
      "in one pose and one grasp.");
}

void say_methods(report::Page& page, const HardnessStudy& study) {
  page.heading("By method");
  page.table(method_table(study));
  page.paragraph(
      "At home, φ = 45°, the stylus leaning towards the person: means over directions. Gains are of the "
      "felt moment over force only, with the least and the largest; the last columns are the directions "
      "in which it changes by more than 2 %. These directions are a sample; over " +
      std::to_string(directions(kManyDirections).size()) + " it is:");
  page.table(means_table(study.means));
  page.paragraph(
      "Extended rate-hardness, (max dF/dt)/v₀, is that of force alone, as published: methods of the same "
      "force have the same. Felt rate-hardness is (max dF/dt)/v₀ of the contact force that would feel as "
      "strong. A contact of force F is felt as F and as a moment |r| F sin φ; with the moment counted in "
      "units of |r| its size is F √(1 + sin²φ). So a felt force f and moment m_r feel as strong as F = "
      "√((f² + m_r²/|r|⁠²)/(1 + sin²φ)). Where the motors add no moment that is f, and both figures "
      "agree. It is the unit in which the exact method weighs them; how a hand weighs them is not known.");
  page.heading("In the tick");
  page.paragraph(
      "Elsewhere on this page the motors alone bound a pulse. In a tick so does what the device's file gives "
      "for "
      "the whole: " +
      number(study.max_force) + " N and " + number(study.max_torque) +
      " N m. Every method keeps to both in what it computes. So much remains; the last column is the "
      "directions in "
      "which the whole's limits take something away:");
  page.table(tick_table(study));
}

void say_directions(report::Page& page, const HardnessStudy& study) {
  page.heading("Where: the direction of the surface");
  page.panels(
      sky_panels(study, &Gain::moment),
      "Surfaces at home by the way they face, seen from above: the middle faces up, the rim sideways; "
      "equal areas of the disc are equal parts of all directions. Surfaces that face down have the "
      "values of those opposite. 'To person': the stylus leans towards the person, or upwards where the "
      "surface faces the person. 'All leans': the mean over eight sides. Blue: force is worth more "
      "there, and the exact method gives moment away for it.");
  page.panels(sky_panels(study, &Gain::hardness),
              "The same for the contact force that would feel as strong: what force is gained or given "
              "away counts too.");
}

void say_angles(report::Page& page, const HardnessStudy& study) {
  page.heading("Where: the angle of the stylus");
  page.plot(moment_plot(study),
            "Means over directions, leaning towards the person. The dotted line is |r × f_des|, which no "
            "method passes.");
  page.table(angle_table(study));
  page.paragraph(
      "At φ = 0 a moment cannot help: r × f_des is 0, a contact has no moment at the grasp, and more "
      "than the contact's own is never made. How far from 0 that reaches depends on how much is missing. "
      "The motors' moment is bounded, the contact's own grows with the strike: for a hard strike a "
      "degree or two is enough, for a slow one it takes tens. Between, a large gain at a small angle is "
      "little more than a small moment made larger.");
  page.plot(
      speed_plot(study),
      "Means over directions, leaning towards the person. A strike within the motors misses nothing, and "
      "there is nothing to stand in for." +
          std::string(study.spare_motors ? " Grey: what motors to spare give to the force alone." : ""));
}

void say_paper(report::Page& page, const HardnessStudy& study) {
  page.heading(study.axes.empty() ? "Where: how the stylus is held"
                                  : "Where: how the stylus is held, and the paper's claim");
  page.plot(lean_plot(study),
            "The part of the felt moment along r × f; below 0 it is felt the other way than a contact's.");
  const double without = leans_without(study);
  page.paragraph(
      without > 0
          ? "At a surface that faces up, at home, Algorithm 1 finds no moment for " + percent(without) +
                " of the sides to which a stylus can lean: there the motor that the force saturates is "
                "the one that the moment would load further. For the others it does. Which it is depends "
                "on the hand, not on the surface alone."
          : "At a surface that faces up, at home, Algorithm 1 finds a moment to whichever side the stylus "
            "leans.");
  if (study.axes.empty()) return;
  page.paragraph(
      "With the grasp on the line between the arms' ends, where this device has its stylus, surfaces "
      "along the three axes come to this:");
  page.table(axis_table(study));
  page.paragraph("And, with that grasp, over surfaces of every direction (" +
                 std::to_string(directions(kManyDirections).size()) + ", whatever φ comes of it):");
  page.table(means_table(study.along_stylus));
  if (study.device != "w6d") return;
  page.paragraph(
      "That is the pose of the study, and its surface is the first line. With line 9 of Algorithm 1 in "
      "the sign that its own Eq. 5 asks for (m_r = r × f - m), and the pseudoinverse, δ is 0: the hybrid "
      "pulse is the force pulse, and nothing is left that could have been felt as harder. With the sign "
      "as printed there is a moment, and it takes away from what a contact would have at the grasp; a "
      "moment turned round is what the study's authors felt as softer. So the claim as it stands, at "
      "this pose, with this grasp and by that algorithm, is not borne out by the device's own "
      "kinematics. Held to another side, it can be. The exact method gives more of both at the same "
      "surface: not by a moment, but by letting the two arms push against each other along the stylus, "
      "where nothing of it is felt.");
}

void say_cost(report::Page& page, const HardnessStudy& study) {
  page.heading("Error against cost");
  page.plot(cost_plot(study), "Of each method the median and, to the right, the 99 % of its processor time.");
  page.table(cost_table(study));
  const PulseChecks& checks = study.checks;
  double slowest = 0;
  for (const MethodCost& cost : checks.costs) slowest = std::max(slowest, cost.p99_us);
  page.paragraph(
      "Over " + std::to_string(checks.cases) +
      " random poses and pulses, 0.05 to 150 N, with grasps up to 0.2 m away. What is missing is of the "
      "wanted felt wrench, over the " +
      std::to_string(checks.clamped) +
      " pulses that were beyond the motors. Time is a tick's allocation, the device's kinematics "
      "included, on the machine that made this page, over the " +
      std::to_string(checks.cases - checks.beyond) + " poses within reach. The budget is " +
      number(kBudget_us) + " µs for 99 %: " + (slowest <= kBudget_us ? "met, at " : "missed, at ") +
      number(slowest) + " µs.");
  page.paragraph(
      "In what it makes small, the squares of missing force and of missing felt moment over |r|, the "
      "exact method was " +
      std::string(checks.worst_margin <= kRoundingLeft ? "never" : "sometimes") +
      " worse than Algorithm 1 or the pseudoinverse. At its worst it was " +
      short_number(std::abs(checks.worst_margin), 2) + " of the wanted wrench's square " +
      (checks.worst_margin > 0 ? "above" : "below") +
      " the better of them; it was below by 0.1 % and more in " + std::to_string(checks.better) + " of the " +
      std::to_string(checks.clamped) + ". The largest load of a motor was " +
      short_number(100 * checks.largest_load, 12) + " % of its limit.");
}

void say_rest(report::Page& page, const HardnessStudy& study) {
  if (study.renders_torque) {
    page.heading("Where: the pose");
    page.panels(
        pose_panels(study),
        "Handle positions within 0.8 of the workspace, seen from above; columns are heights over home. "
        "Means over directions, leaning towards the person. Empty: out of reach. The handle is turned as "
        "at home: the stylus' angle sets where the grasp is, and no more.");
    page.heading("Force against moment");
    page.plot(
        front_plot(study),
        "Lines: the exact method as the weight of missing moment goes from 0.01 to 100, for surfaces at "
        "home that face as named. Straight lines join corners of what the motors can do; a point alone "
        "is best at every weight.");
  }
  say_cost(page, study);
  page.heading("Shown, and not used");
  page.paragraph(
      "What the exact method keeps has a price. The nearest wrench keeps nothing, and its force is "
      "tilted: a surface would be felt to face another way. A free moment keeps the force's direction "
      "and takes whatever moment is nearest. It turns the hand about an axis that the contact has not, "
      "and it can be more than the contact's own.");
  page.table(shown_table(study));
}

void say_setting(report::Page& page, const HardnessStudy& study) {
  page.heading("What was struck, and how");
  const StrikeSetting& s = study.setting;
  std::string limits;
  for (const auto& [name, limit] : study.limits)
    limits += (limits.empty() ? "" : ", ") + name + " " + number(limit);
  page.facts({{"device", study.title + " (" + study.device + ")"},
              {"motors' limits", limits + " (N m at joints, N along axes)"},
              {"hand", number(s.hand_mass) + " kg, 0.6 % of 75 kg, at " + number(s.speed) + " m/s"},
              {"wanted", "m v/(N T) = " + number(s.wanted_force()) + " N for one tick of " +
                             number(1e3 * s.tick_s) + " ms"},
              {"grasp", "|r| = " + number(1e3 * s.lever) + " mm from where the force acts"},
              {"surface", short_number(s.stiffness) + " N/m"},
              {"directions",
               std::to_string(directions(kDirections).size()) + ": the axes, and an even spread; " +
                   std::to_string(directions(kPoseDirections).size()) + " for the curves and for poses"}});
  page.paragraph(
      "Rate-hardness comes of a simulated strike: the hand's mass and the device's, with its friction "
      "and damping, meet the spring at that speed, the pulse in the tick of contact. Contact falls on a "
      "tick, so that the pulse has the motors to itself, and positions are exact.");
}

}  // namespace

report::Page hardness_page(const HardnessStudy& study) {
  report::Page page("Where a moment makes a surface feel harder: " + study.title);
  say_answer(page, study);
  if (study.renders_torque) say_directions(page, study);
  say_methods(page, study);
  if (study.renders_torque) {
    say_angles(page, study);
    say_paper(page, study);
  }
  say_rest(page, study);
  say_setting(page, study);
  return page;
}

}  // namespace fulcrum::analysis::hardness
