#include "engine/app/edit/edit_loop.h"

#include <cstdio>
#include <memory>
#include <optional>
#include <utility>

#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/picture/picture.h"
#include "engine/app/run/run_session.h"
#include "engine/app/window/prepare_in_window.h"
#include "engine/app/window/training_window.h"

namespace fulcrum::app {
namespace {

// What goes on from one save to the next.
struct Place {
  render::OrbitCamera camera;
  Pose X_WM;  // of the tool's model
};

class Author {
public:
  Author(WindowStage& stage, std::filesystem::path file, const scenario::Scenario& shown,
         const RunOptions& options, std::filesystem::path calibration)
      : stage_(stage), options_(options), editor_(std::move(file), shown, std::move(calibration)) {
    options_.records = false;
  }

  // Until the window is closed, or nothing can be drawn.
  int work(std::unique_ptr<Prepared> prepared) {
    std::optional<Place> place;
    editor_.reloader().watch_beside(*prepared);
    for (;;) {
      const Pose X_WT_start = prepared->haptic.scene.tool.X_WT_start;
      if (place) begin_at(*prepared, place->X_WM);
      const Result<scenario::VisualAssembly> visual =
          assemble_shown(*prepared, scene_for_device(*prepared, options_.device), options_);
      if (!visual) return refuse(visual.error().sentence);
      const Result<std::unique_ptr<TrainingWindow>> window =
          TrainingWindow::create(stage_, *prepared, *visual, options_, nullptr, false);
      if (!window) return refuse(window.error().sentence);
      (*window)->edit_by(editor_);
      if (place) (*window)->look_as(place->camera);
      if (!run(*prepared, **window, X_WT_start, place)) return code_;
      if (std::unique_ptr<Prepared> next = editor_.reloader().take()) {
        prepared = std::move(next);
        std::printf("%s has been read.\n", prepared->name.c_str());
        std::fflush(stdout);
      }
    }
  }

private:
  int refuse(const std::string& sentence) {
    complain(sentence);
    return kError;
  }

  // False: it is over, with a code.
  bool run(Prepared& prepared, TrainingWindow& window, const Pose& X_WT_start, std::optional<Place>& place) {
    using Leave = TrainingWindow::Leave;
    for (;;) {
      const std::unique_ptr<RunSession> attempt = RunSession::begin(prepared, options_, nobody_);
      if (!attempt) {
        code_ = kError;
        return false;
      }
      attempt->play_sound(false);
      const Leave leave = window.run(attempt->world(), attempt->device(), attempt->sink(), attempt->faults(),
                                     attempt->player(), [] { return true; });
      if (leave == Leave::restart) {
        prepared.haptic.scene.tool.X_WT_start = X_WT_start;
        continue;
      }
      const Pose X_MT{Quat::Identity(), prepared.models.p_MT};
      place = Place{window.orbit(), window.left_X_WT() * X_MT.inverse()};
      return leave == Leave::reload;
    }
  }

  WindowStage& stage_;
  RunOptions options_;
  Trainee nobody_;
  SceneEditor editor_;
  int code_ = kCompleted;
};

}  // namespace

int edit_in_window(WindowStage& stage, const scenario::Scenario& scenario, const std::filesystem::path& file,
                   const std::filesystem::path& calibration, const RunOptions& options) {
  // Before the models are read: a save meanwhile is none that is lost.
  Author author(stage, file, scenario, options, calibration);
  PreparedInWindow ready = prepare_in_window(stage, file.string(), scenario);
  if (ready.closed || ready.cancelled) return kNotCompleted;
  if (!ready.prepared) return kError;
  for (const std::string& note : ready.prepared->haptic.repaired) complain(note);
  return author.work(std::make_unique<Prepared>(std::move(*ready.prepared)));
}

}  // namespace fulcrum::app
