#include "engine/app/run/debrief.h"

#include <cmath>
#include <cstdio>
#include <string>

#include "engine/report/axis.h"
#include "engine/session/score.h"

namespace fulcrum::app {
namespace {

std::string with_value(const char* pattern, double value) {
  char text[80];
  std::snprintf(text, sizeof text, pattern, value);
  return text;
}

ui::Debrief::Row row_of(const session::Criterion& criterion) {
  ui::Debrief::Row row{criterion.name, criterion.value, {}, criterion.reason};
  if (criterion.points)
    row.points = report::short_number(*criterion.points, 3) + " of " + report::short_number(criterion.of, 3);
  return row;
}

// What was done before: "Trial", "3", "Your best yet, by 4 points; the last one 66."
ui::Debrief::Row row_of(const EarlierTrials& earlier, double points) {
  const double gained = std::round(points) - std::round(earlier.best);
  std::string reason = gained > 0 ? with_value("Your best yet, by %.0f points; ", gained)
                                  : with_value("Your best had %.0f points; ", earlier.best);
  if (gained == 0) reason = "As good as your best; ";
  reason += with_value("the last one %.0f.", earlier.last);
  return {"Trial", std::to_string(earlier.count + 1), {}, reason};
}

}  // namespace

ui::Debrief debrief(const Prepared& prepared, const RunSink& sink, const Comparison& with,
                    bool has_start_page, bool has_pad) {
  const scenario::TaskDesc& task = prepared.haptic.task;
  const scenario::TaskState& state = sink.task();
  const bool completed = sink.end() == RunSink::End::completed;
  const session::Score score = session::score(sink.metrics(), with.expert, task.score);
  ui::Debrief debrief;
  debrief.title = completed ? with_value("Completed in %.1f s", sink.time())
                            : with_value("Time is up after %g s", sink.limit());
  if (sink.guided()) debrief.title += ", guided: no points";
  if (score.total) debrief.title += with_value(": %.0f of 100 points", *score.total);
  if (with.earlier && score.total) debrief.rows.push_back(row_of(*with.earlier, *score.total));
  for (const session::Criterion& criterion : score.criteria) debrief.rows.push_back(row_of(criterion));
  for (std::size_t i = 0; i < task.checkpoints.size(); ++i) {
    const std::optional<double>& reached = state.reached[i];
    debrief.rows.push_back({task.checkpoints[i].name,
                            reached ? with_value("%.1f s", *reached) : "-",
                            {},
                            reached                        ? ""
                            : task.checkpoints[i].optional ? "not reached; it need not be"
                                                           : "not reached"});
  }
  const std::string again = has_pad ? "R, or Y on the pad, starts again" : "R starts again";
  const std::string back = has_pad ? "F10, or Back," : "F10";
  debrief.foot =
      again + (has_start_page ? ", " + back + " goes back to the start page." : "; close the window to end.");
  return debrief;
}

}  // namespace fulcrum::app
