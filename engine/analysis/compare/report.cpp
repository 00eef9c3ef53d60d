#include "engine/analysis/compare/report.h"

#include "engine/analysis/compare/figures.h"
#include "engine/analysis/compare/tables.h"

namespace fulcrum::analysis::compare {
namespace {

using report::short_number;

std::string number(double value) {
  return short_number(value, 4);
}

bool recorded(const Comparison& comparison) {
  return comparison.hand.empty();
}

std::size_t trial_count(const Comparison& comparison) {
  return comparison.variants.front().trials.size();
}

// "E_τ falls from 2.25 to 0.872 N m s (intervals apart)"
std::string change(const Estimate& from, const Estimate& to, const MetricName& name) {
  const std::string symbol = name.symbol;
  std::string unit;  // no line breaks in it
  for (const char c : " " + std::string(name.unit)) c == ' ' ? unit.append("\u00a0") : unit.append(1, c);
  if (from.n == 0 || to.n == 0) return symbol + " has no values to compare";
  const std::string before = number(from.mean), after = number(to.mean);
  const std::string moved = before == after ? " stays at " + after
                                            : (to.mean < from.mean ? " falls" : " rises") +
                                                  std::string(" from ") + before + " to " + after;
  const std::string how = !from.interval || !to.interval ? ""
                          : apart(from, to)              ? " (intervals apart)"
                                                         : " (intervals overlap)";
  return symbol + moved + unit + how;
}

std::string verdict(const VariantRuns& runs, const VariantRuns& reference) {
  std::string text = "From " + reference.name + " to " + runs.name;
  for (const Metric metric : kMetrics) {
    text.append(metric == kMetrics.front() ? ": " : "; ");
    text += change(estimate_of(reference, metric), estimate_of(runs, metric), name_of(metric));
  }
  return text.append(".");
}

void say_what(report::Page& page, const Comparison& comparison) {
  page.command(comparison.command);
  std::string note = reservation(comparison);
  if (comparison.yields) note += " They are listed below.";
  page.note(note);
  page.paragraph(
      "A device that senses six axes and pushes in three cannot push back when the tool is turned against "
      "what holds it. Torque substitution tells of it by other means. Variant A: nothing is told. B: the "
      "handle vibrates while the torque is bad, that is, while no force that the hand feels explains it. "
      "C: B, and while the torque is large a ghost of the tool shows where the hand has turned to.");
}

void say_result(report::Page& page, const Comparison& comparison) {
  page.heading("What came of it");
  for (std::size_t v = 1; v < comparison.variants.size(); ++v)
    page.paragraph(verdict(comparison.variants[v], comparison.variants.front()));
  page.table(compare_table(comparison));
  page.paragraph(
      "E_τ = ∫|τ_v| dt: the coupling's torque on the tool, over the run. E_F = ∫|F_c| dt: the force of "
      "contact, "
      "of the scene on the tool, without the tool's weight. t_c: when the last checkpoint counted. " +
      std::string(
          trial_count(comparison) > 1
              ? "After ±: half of the mean's 95 % confidence interval over the trials, by Student's t."
              : "One trial has no interval."));
  if (trial_count(comparison) == 1) return;
  if (comparison.variants.size() > 1) {
    page.table(difference_table(comparison));
    page.paragraph(
        "Differences are taken trial by trial: a trial has the same seed, and with it the same hand, in "
        "every variant. An interval without 0 in it is a difference that the seeds do not explain.");
  }
  for (const Metric metric : kMetrics)
    if (estimate_of(comparison.variants.front(), metric).n > 0)
      page.plot(metric_plot(comparison, metric), "Grey: each trial, joined over the variants.");
}

void say_course(report::Page& page, const Comparison& comparison) {
  page.heading("One trial over time");
  page.paragraph(
      "The coupling's torque in the first trial of each variant, as long as there is any, and above it how "
      "strong the cues are: vibration against the strongest of these trials, the ghost by its opacity.");
  for (std::size_t v = 0; v < comparison.variants.size(); ++v) page.plot(course_plot(comparison, v), "");
}

report::Facts hand_facts(const YieldingDesc& yields) {
  const auto rms = [](double rad) { return number(rad) + " rad rms"; };
  return {{"reaction", number(yields.reaction) + " s from a cue to the first motion by it"},
          {"gain", number(yields.gain) + " rad/s of turning back at a full cue"},
          {"spread", number(100 * yields.spread) +
                         " % of both from trial to trial: log-normal, the figures above their medians"},
          {"full cue", number(yields.full_vibration) + " N of vibration, or an opaque ghost; below " +
                           number(yields.least_vibration) + " N nothing is felt"},
          {"error of the way", rms(yields.felt_error_rad) + " under vibration alone, " +
                                   rms(yields.seen_error_rad) + " where the ghost is seen"},
          {"recovery",
           "goes on as before without a cue, with a time constant of " + number(yields.recovery) + " s"}};
}

void say_setting(report::Page& page, const Comparison& comparison) {
  page.heading("What was run");
  report::Facts facts{
      {"scenario", comparison.title + " (" + comparison.scenario + ")"},
      {"device", comparison.device + (recorded(comparison) ? ", recorded" : ", simulated")},
      recorded(comparison) ? std::pair{"motion", comparison.tape} : std::pair{"hand", comparison.hand},
      {"trials", std::to_string(trial_count(comparison)) + " of each variant, up to " +
                     number(comparison.time_limit_s) + " s of simulated time"}};
  facts.insert(facts.end(), comparison.built.begin(), comparison.built.end());
  page.facts(facts);
  std::size_t unfinished = 0, stopped = 0;
  for (const VariantRuns& runs : comparison.variants) {
    for (const Trial& trial : runs.trials) {
      stopped += trial.fault.empty() ? 0 : 1;
      unfinished += trial.completion_time_s ? 0 : 1;
    }
  }
  if (unfinished > 0)
    page.paragraph("Trials that did not complete, and have no t_c: " + std::to_string(unfinished) + ".");
  if (stopped > 0)
    page.paragraph("Trials that a fault ended, and that count for nothing: " + std::to_string(stopped) + ".");
  if (!comparison.yields) return;
  page.paragraph("The hand's figures. They are chosen, not measured:");
  page.facts(hand_facts(*comparison.yields));
}

void say_simulated(report::Page& page, const Comparison& comparison) {
  page.heading("What is simulated, and what is not");
  page.paragraph(
      "Not simulated: the haptic tick. Contact, coupling, the classifier of torque, the cues and the safety "
      "after them are the code that runs in a person's hand, at its own rate.");
  if (recorded(comparison)) {
    page.paragraph(
        "The motion is a recording: it is the same whatever it is told, and cannot yield. Between variants "
        "only that can differ which a cue itself does to tool and coupling, and a cue is kept out of both; "
        "variants that agree to the last digit are what should come of it.");
    return;
  }
  page.paragraph(
      "Simulated: the device, with the mass, friction and encoder steps of its description, and the hand, a "
      "spring and damper about a written path, with tremor. Where it turns the tool against what holds it, "
      "it does so because its path was written that way.");
  if (!comparison.yields) {
    page.paragraph("This hand does not yield: it does what it meant to do, whatever it is told.");
    return;
  }
  page.paragraph(
      "Simulated, and assumed: that the hand yields. It turns the handle back where it perceives a cue, one "
      "reaction time late, as fast as the cue is strong. Vibration does not say which way; the ghost does: "
      "two of the figures above stand for that, and nobody has measured them here. Without a cue the hand "
      "goes back to what it meant to do.");
  page.paragraph(
      "So the order of the variants is built into the hand. What the page shows is that the chain from "
      "contact to cue to hand works, how large the effect is for a hand of these figures, and, run again "
      "with --set hands.NAME.yields.gain=..., how it changes with them. It does not show that people turn "
      "back when a handle vibrates, how many do, how soon, or what they learn: that takes people. Not in "
      "the model at all: attention, grip, getting used to a cue. The intervals are over what the seed "
      "decides: tremor, errors of the way, and a reaction and a gain for each trial; they are no spread "
      "over people. t_c follows the path's timetable.");
}

}  // namespace

const char* reservation(const Comparison& comparison) {
  if (recorded(comparison))
    return "One recorded motion of a handle, run again under each variant. It cannot yield to a cue: what "
           "follows says nothing about how people answer one.";
  if (!comparison.yields)
    return "The hand is a program, and one that does not yield to cues. Nothing here is a finding about "
           "people.";
  return "The hand is a program. Nothing here is a finding about people: it yields to cues because it was "
         "written to, by figures that were chosen.";
}

report::Page compare_page(const Comparison& comparison) {
  std::string names;
  for (const VariantRuns& runs : comparison.variants) names += (names.empty() ? "" : ", ") + runs.name;
  report::Page page("Torque substitution, variants " + names + ": " + comparison.title);
  say_what(page, comparison);
  say_result(page, comparison);
  say_course(page, comparison);
  say_setting(page, comparison);
  say_simulated(page, comparison);
  return page;
}

}  // namespace fulcrum::analysis::compare
