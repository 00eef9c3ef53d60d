#pragma once
// Looking back at a trial that has ended: the moment that is shown, and how keys and presses move it.

#include <optional>
#include <vector>

#include "engine/app/run/film.h"
#include "engine/app/run/run_sink.h"
#include "engine/ui/timeline.h"

namespace fulcrum::app {

class Review {
public:
  explicit Review(double tick_s) : film_(tick_s) {}

  // Each tick of the trial.
  void add(const TickRecord& record, double time) { film_.add(record, time); }

  enum class Key { back, on, before, after, card };  // before, after: to the event there
  // After the end. far: a second in place of a tenth.
  void press(Key key, const RunSink& sink, bool far);
  void go_to(double time, const RunSink& sink);

  // A moment is shown, in place of the card that says what came of the trial.
  bool is_shown() const { return at_.has_value() && !film_.empty(); }
  const TickRecord& record() const { return film_.at(*at_); }
  // As the task stood then.
  scenario::TaskState task(const RunSink& sink) const;
  ui::Timeline timeline(const RunSink& sink) const;

private:
  std::optional<double> at_;  // s
  Film film_;
};

}  // namespace fulcrum::app
