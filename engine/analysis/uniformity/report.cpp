#include "engine/analysis/uniformity/report.h"

#include <algorithm>
#include <cmath>

#include "engine/analysis/uniformity/figures.h"
#include "engine/analysis/uniformity/tables.h"

namespace fulcrum::analysis::uniformity {
namespace {

using report::short_number;

std::string number(double value, int digits = 3) {
  return short_number(value, digits);
}
std::string percent(double part, int digits = 2) {
  return short_number(100 * part, digits) + " %";
}

constexpr double kFormulasHold = 0.01;  // what they are to hold to

// Over the stiffnesses.
struct Worst {
  double stiffness = 0, torque_over = 0, jump = 0;
  int limited = 0;
};
Worst worst_of(const UniformityStudy& study, InertiaMethod method) {
  Worst worst;
  for (const double stiffness : kStiffnesses) {
    const StickSummary s = summary_of(study, method, stiffness);
    worst.stiffness = std::max(worst.stiffness, s.worst);
    worst.torque_over = std::max(worst.torque_over, s.torque_over);
    worst.jump = std::max(worst.jump, s.jump);
    worst.limited += s.limited;
  }
  return worst;
}

void say_strikes(report::Page& page, const UniformityStudy& study) {
  page.heading("The stick");
  page.plot(stiffness_plot(study),
            "Means along the whole stick, and the scatter from strike to strike as bars. A mass that is "
            "slowed down "
            "takes m a off what the hand feels of any ball, which is most of a soft one.");
  page.plot(
      torque_plot(study, 300),
      "Where the hand holds the stick, nothing should turn it. Uncompensated, the stage's mass does. Method "
      "1 "
      "commands h × f about the stage while the contact lies between hand and stage, and jumps as it passes "
      "the hand.");
  page.panels(
      torque_panels(study),
      "From the stage, left, to the stick's end; the hand is in the middle. What a person tells: 12.7 %, and "
      "no less than 8 mN m.");
  page.table(summary_table(study));
}

void say_filters(report::Page& page, const UniformityStudy& study) {
  page.heading("Acceleration from position");
  page.plot(
      lag_plot(study),
      "Lag at low frequency and noise, as each filter states them of its steady gain, and against exact "
      "motion: "
      "1 Hz, 20 mm, and the same through the encoder. The adaptive one expects less jerk while it sees less, "
      "so that there it lags more than at the jerk it was given, and is quieter.");
  page.plot(cost_plot(study),
            "A hand that moves by 10 mm at 2 Hz and trembles, through the encoder; each mark is a jerk.");
  report::Table table;
  table.head = {"filter",      "jerk, m/s³/√Hz", "lag, ms",     "measured",
                "noise, m/s²", "measured",       "error, m/s²", "run time, ns"};
  for (const FilterRow& row : study.filters)
    table.rows.push_back({std::string(name_of(row.kind)), number(row.jerk), number(1e3 * row.lag),
                          number(1e3 * row.measured_lag), number(row.noise), number(row.measured_noise),
                          number(row.error), number(row.cpu_ns)});
  page.table(table);
}

void say_limits(report::Page& page, const UniformityStudy& study) {
  const InertiaLoop& hand = study.hand;
  page.heading("How late it may be");
  page.paragraph(
      "m a that is late pushes on where the hand has already turned back. Mass, damper and spring of the "
      "hand (" +
      number(1e3 * hand.hand_mass) + " g, " + number(hand.damping) + " N s/m, " +
      number(hand.hand_stiffness) +
      " N/m), the device's mass, the held force and the filter of three "
      "states make a linear loop that is solved exactly. To first order it is stable for lags below "
      "(M + (1 - g) m) b / (g m (k + K)). Crosses: the true acceleration, whole ticks late.");
  page.plot(limit_plot(study), "Above its line the hand shakes.");
  page.plot(
      mass_plot(study),
      "A light hand bears less. Where a line ends, no lag is too long any more, or none is short enough.");
  report::Table table;
  table.head = {"lag, ms",   "growth, 1/s",          "it fades at, s",
                "swing, mm", "swing, not faded, mm", "closed-loop port, J"};
  for (const LateRun& run : study.late)
    table.rows.push_back({number(1e3 * run.lag), number(run.growth),
                          run.faded_at < 0 ? "never" : number(run.faded_at), number(1e3 * run.swing),
                          number(1e3 * run.swing_unfaded), number(run.least_port)});
  page.paragraph("The same hand presses on a ball of " + number(hand.wall_stiffness) +
                 " N/m, in the simulator's own tick. Compensation may give the hand " +
                 number(1e3 * InertiaCompensationDesc{}.budget) +
                 " mJ and fades beyond it; beside it the same without that budget.");
  page.plot(late_plot(study), "The latest of the table.");
  page.table(table);
}

void say_checks(report::Page& page, const UniformityStudy& study) {
  const InertiaChecks& c = study.checks;
  page.heading("Formulas");
  page.facts({{"method 2 with the true acceleration",
               "f and h × f to " + number(study.true_acceleration, 2) +
                   " of them: the same strikes, with an even acceleration and an encoder of no steps"},
              {"wrong control point",
               c.control_point > 0 ? "J_true⁻ᵀ J_usedᵀ F is the wrench moved from one to the other, to " +
                                         number(c.control_point, 2) + " of it"
                                   : "not checked: the device is no arm of six motors"},
              {"m .25 kg, a 1 m/s², l .1 m, h .03 m, f 1 N",
               "wanted " + number(1e3 * c.wanted) + " mN m, uncompensated " + number(1e3 * c.uncompensated) +
                   ", by Eq. 11 as printed " + number(1e3 * c.as_printed)}});
}

void say_setting(report::Page& page, const UniformityStudy& study) {
  const StrikePath& path = study.path;
  page.heading("What was done");
  page.command(study.command);
  page.facts(
      {{"device", study.device + ", " + number(1e3 * study.mass) + " g at the stage, encoder " +
                      number(1e6 * study.encoder_step) + " µm"},
       {"stick",
        number(1e3 * kStickLength) + " mm from the stage, held at " + number(1e3 * path.held) + " mm"},
       {"strikes", std::to_string(study.strikes) + " for each place, stiffness and method; each with its own "
                                                   "tremor and phase of the encoder"},
       {"motion", "the hand slows down by " + number(path.acceleration) + " m/s² and is measured " +
                      number(1e3 * path.depth) + " mm inside, " + number(1e3 * path.beyond) +
                      " mm before it would rest; tremor " + number(1e6 * path.tremor) + " µm rms"},
       {"filter",
        number(1e3 * study.filter_lag) + " ms late, " + number(study.filter_noise) + " m/s² of noise"}});
  double depth_error = 0, resistance = 0;
  for (const UniformityRow& row : study.rows) {
    depth_error = std::max(depth_error, row.depth_error);
    resistance = std::max(resistance, row.resistance);
  }
  page.paragraph(
      "The tick runs as in any scene, guard and motors included; the stick does not turn, so that I α "
      "plays no part. A force is held for a tick: it is compared with what it is to be half way through. "
      "The formulas take the contact's force for the depth that it was found at, which by then is off by up "
      "to " +
      number(1e6 * depth_error, 2) +
      " µm: half a tick of the way in, half a count of the encoder and the field's voxels. Passivity control "
      "resists by up to " +
      number(1e3 * resistance, 2) +
      " mN, which they count to the device, at the stage. What is felt of stiffness holds both as errors.");
}

// Of what a person tells.
std::string told_words(double stiffness_off) {
  return (stiffness_off < kStiffnessJnd ? "not told: below the " : "told: not below the ") +
         percent(kStiffnessJnd) + " that are just noticeable";
}
std::string jump_words(double jump) {
  const std::string size = number(1e3 * jump) + " mN m";
  return jump > kTorqueLeast ? "jumps by up to " + size + " as the contact passes the hand"
                             : "does not jump at the hand: " + size + " at most, and " +
                                   number(1e3 * kTorqueLeast) + " are not felt";
}
std::string scatter_words(const UniformityStudy& study, double stiffness) {
  const double part = summary_of(study, InertiaMethod::acceleration, stiffness).scatter / stiffness;
  return percent(part) + " on " + number(stiffness) + " N/m" +
         (part < kStiffnessJnd ? " (not told)" : " (told from one strike to the next)");
}

}  // namespace

std::vector<std::string> uniformity_answer(const UniformityStudy& study) {
  const Worst none = worst_of(study, InertiaMethod::none), arm = worst_of(study, InertiaMethod::arm),
              acceleration = worst_of(study, InertiaMethod::acceleration);
  double formulas = 0;
  for (const UniformityRow& row : study.rows)
    if (row.method == InertiaMethod::none) formulas = std::max(formulas, row.formula_error);
  std::vector<std::string> answer{
      "Uncompensated, stiffness is off by up to " + percent(none.stiffness) + " and torque by up to " +
          number(none.torque_over, 2) + " times what is told; " +
          (formulas <= kFormulasHold ? "as the formulas predict, to " : "the formulas miss it, by up to ") +
          percent(formulas) + " in every strike.",
      "Method 1 (arm): stiffness is off by up to " + percent(arm.stiffness) + ", and torque " +
          jump_words(arm.jump) + ".",
      "Method 2 (acceleration): stiffness is off by up to " + percent(acceleration.stiffness) +
          " in the mean along the whole stick (" + told_words(acceleration.stiffness) +
          "), torque by up to " + number(acceleration.torque_over, 2) + " times what is told, and " +
          jump_words(acceleration.jump) + ". With the true acceleration it is exact to " +
          number(study.true_acceleration, 2) + ".",
      "From strike to strike it scatters by " + scatter_words(study, kStiffnesses.back()) +
          ", the stiffest ball, and by " + scatter_words(study, kStiffnesses.front()) + ", the softest."};
  const int limited = none.limited + arm.limited + acceleration.limited;
  if (limited > 0)
    answer.push_back("In " + std::to_string(limited) +
                     " strikes the device could not give all that was wanted.");
  return answer;
}

report::Page uniformity_page(const UniformityStudy& study) {
  report::Page page("Does a ball feel alike along the whole stick? " + study.device);
  for (const std::string& sentence : uniformity_answer(study)) page.paragraph(sentence);
  say_strikes(page, study);
  say_filters(page, study);
  say_limits(page, study);
  say_checks(page, study);
  say_setting(page, study);
  return page;
}

}  // namespace fulcrum::analysis::uniformity
