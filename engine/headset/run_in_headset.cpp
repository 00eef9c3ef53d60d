#include "engine/headset/run_in_headset.h"

#include <memory>
#include <optional>
#include <string>
#include <utility>

#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/interrupt.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/picture/picture.h"
#include "engine/app/run/expert.h"
#include "engine/headset/headset_run.h"
#include "engine/record/run_folder.h"

namespace fulcrum::headset {
namespace {

// Null: the scene is before who wears the headset.
std::unique_ptr<Colocated> colocated(const app::RunOptions& options, std::optional<scenario::Colocation> kept,
                                     const MappingDesc& mapping) {
  if (options.headset.colocate)
    return std::make_unique<Colocated>(options.headset, app::device_on_desk(options.device), mapping);
  return kept ? std::make_unique<Colocated>(std::move(*kept), mapping) : nullptr;
}

}  // namespace

int run_in_headset(const scenario::Scenario& scenario, const app::RunOptions& options,
                   app::Participation* participation) {
  using namespace app;
  Result<std::optional<scenario::Colocation>> kept = kept_colocation(options.headset, options.device);
  if (!kept) {
    complain(kept.error().sentence);
    return kError;
  }
  // First: without a headset nothing is baked.
  const Result<std::unique_ptr<HeadsetStage>> stage =
      HeadsetStage::create("Fulcrum: " + scenario.title, options);
  if (!stage) {
    complain(stage.error().sentence);
    return kError;
  }
  const std::optional<Prepared> prepared = prepare(options.scenario, scenario);
  if (!prepared) return kError;
  for (const std::string& note : prepared->haptic.repaired) complain(note);
  std::optional<ExpertRun> expert;
  if (participation != nullptr) expert = watch_expert_in_terminal(*prepared);
  if (interrupted()) {
    complain("interrupted before the trial began: nothing was run.");
    return kNotCompleted;
  }
  const Result<scenario::VisualAssembly> visual =
      assemble_shown(*prepared, scene_for_device(*prepared, options.device), options);
  const Settings settings = read_settings();
  const std::optional<Error> undrawn =
      visual ? (*stage)->set_scene(visual->desc, settings.first_quality()) : visual.error();
  if (undrawn) {
    complain(undrawn->sentence);
    return kError;
  }
  std::unique_ptr<Panel> panel;
  if (options.overlay != kNoOverlay) {
    auto made = Panel::create((*stage)->gpu());
    if (!made) {
      complain(made.error().sentence);
      return kError;
    }
    panel = std::move(*made);
    if (!panel->font_note().empty()) complain(panel->font_note());
  }
  const Trainee trainee{participation, expert ? &expert->metrics : nullptr};
  const std::unique_ptr<RunSession> attempt = RunSession::begin(*prepared, options, trainee);
  if (!attempt) return kError;
  attempt->play_sound(!options.muted);
  HeadsetRun run(**stage, *prepared, *visual, options, settings, *attempt, std::move(panel),
                 colocated(options, std::move(*kept), attempt->world().desc().mapping),
                 {trainee.expert, participation != nullptr ? earlier_trials(*participation, *prepared)
                                                           : std::optional<EarlierTrials>()});
  // As soon as the trial is over: however long somebody looks at the card, nothing of it is lost then.
  std::optional<int> code;
  const auto write_all = [&] {
    const auto picture = run.save_picture(attempt->folder() / record::kPictureName);
    if (!picture) complain("there is no picture: " + picture.error().sentence);
    code = attempt->finish(&(*stage)->renderer().plan(), true, run.figures());
  };
  run.run(write_all);
  if (!code) write_all();
  for (const std::string& message : (*stage)->validation_messages()) complain(message);
  return (*stage)->validation_messages().empty() ? *code : static_cast<int>(kError);
}

}  // namespace fulcrum::headset
