#include "engine/app/window/train.h"

#include <memory>
#include <optional>
#include <string>

#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/interrupt.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/picture/picture.h"
#include "engine/app/run/run_session.h"
#include "engine/app/window/prepare_in_window.h"
#include "engine/record/run_folder.h"

namespace fulcrum::app {

Trained train(WindowStage& stage, const scenario::Scenario& scenario, const RunOptions& options,
              Participation* participation, bool has_start_page) {
  using Leave = TrainingWindow::Leave;
  const PreparedInWindow ready = prepare_in_window(stage, options.scenario, scenario);
  if (ready.closed) {
    complain(interrupted() ? "interrupted before the trial began: nothing was run."
                           : "the window was closed before the scenario was ready: nothing was run.");
    return {kNotCompleted, Leave::closed};
  }
  if (ready.cancelled) {
    complain("cancelled before the scenario was ready: nothing was run.");
    return {kNotCompleted, Leave::start_page};
  }
  if (!ready.prepared) return {kError, Leave::start_page};
  const Prepared& prepared = *ready.prepared;
  for (const std::string& note : prepared.haptic.repaired) complain(note);
  const Result<scenario::VisualAssembly> visual =
      assemble_shown(prepared, scene_for_device(prepared, options.device), options);
  if (!visual) {
    complain(visual.error().sentence);
    return {kError, Leave::start_page};
  }
  const Trainee trainee{participation, ready.expert ? &ready.expert->metrics : nullptr};
  const Result<std::unique_ptr<TrainingWindow>> window = TrainingWindow::create(
      stage, prepared, *visual, options, ready.expert ? &*ready.expert : nullptr, has_start_page);
  if (!window) {
    complain(window.error().sentence);
    return {kError, Leave::start_page};
  }
  RunOptions attempt_options = options;
  for (int number = 1;; ++number) {
    if (number > 1 && !options.out.empty())
      attempt_options.out = options.out / ("attempt-" + std::to_string(number));
    const std::unique_ptr<RunSession> attempt = RunSession::begin(prepared, attempt_options, trainee);
    if (!attempt) return {kError, Leave::start_page};
    attempt->play_sound(number == 1 && !options.muted);
    if (participation != nullptr) (*window)->compare_with(earlier_trials(*participation, prepared));
    // As soon as the trial is over: whoever looks back at it, and for how long, nothing of it is lost then.
    std::optional<int> code;
    const auto write_all = [&] {
      const auto picture = (*window)->save_picture(attempt->sink(), attempt->folder() / record::kPictureName);
      if (!picture) complain("there is no picture: " + picture.error().sentence);
      code = attempt->finish(&(*window)->plan(), true, (*window)->figures());
      return *code != kError;
    };
    const Leave leave = (*window)->run(attempt->world(), attempt->device(), attempt->sink(),
                                       attempt->faults(), attempt->player(), write_all);
    if (!code) write_all();
    if (leave == Leave::restart) continue;
    for (const std::string& message : stage.validation_messages()) complain(message);
    return {stage.validation_messages().empty() ? *code : static_cast<int>(kError), leave};
  }
}

}  // namespace fulcrum::app
