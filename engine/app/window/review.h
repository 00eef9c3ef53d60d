#pragma once
// Looking back at a trial that has ended: the moment that is shown, and how keys and presses move it.

#include <optional>
#include <string>
#include <vector>

#include "engine/app/run/expert_run.h"
#include "engine/app/run/film.h"
#include "engine/app/run/run_sink.h"
#include "engine/ui/timeline.h"

namespace fulcrum::app {

// Of what the plots show, drawn as lines; none: there is none.
struct PlotLimits {
  std::optional<double> force_N, torque_Nm;
};

// Of the scene on the tool: where a touch counts as a hard one, else what the device can give in the scene.
PlotLimits plot_limits(const SceneDesc& scene, const scenario::TaskDesc& task);

class Review {
public:
  explicit Review(double tick_s);

  // Each tick of the trial.
  void add(const TickRecord& record, double time);

  enum class Key { back, on, before, after, card };  // before, after: to the event there
  // After the end. far: a second in place of a tenth.
  void press(Key key, const RunSink& sink, bool far);
  void go_to(double time, const RunSink& sink);

  // A moment is shown, in place of the card that says what came of the trial.
  bool is_shown() const { return at_.has_value() && !film_.empty(); }
  const TickRecord& record() const { return film_.at(*at_); }
  // As the task stood then.
  scenario::TaskState task(const RunSink& sink, const scenario::TaskDesc& task) const;
  // The moment of the expert's run that belongs to it. A moment is shown.
  double same_part_s(const RunSink& sink, const ExpertRun& expert) const;
  // expert: is shown beside the trainee; null: nobody is.
  ui::Timeline timeline(const RunSink& sink, const PlotLimits& limits = {},
                        const ExpertRun* expert = nullptr) const;

  // What keys jump to: what the trial's meter noted, and where the device gave all that it has.
  struct Event {
    double time = 0;  // s
    std::string words;
    ui::Timeline::Mark::Kind kind = ui::Timeline::Mark::Kind::fair;
  };
  std::vector<Event> events(const RunSink& sink) const;  // in order

private:
  std::optional<double> at_;  // s
  Film film_;
  // Limits that were reached, a Fault bit each; one that comes again at once is the same.
  struct AtLimit {
    std::uint32_t fault = 0;
    const char* words = "";
    std::optional<double> last{};  // s
  };
  std::vector<AtLimit> limits_;
  std::vector<Event> at_limit_;  // at most session::TrialMeter::kMostEvents
};

}  // namespace fulcrum::app
