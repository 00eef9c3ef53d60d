#pragma once
// One attempt, from opened files to closed ones.

#include <chrono>
#include <filesystem>
#include <memory>
#include <optional>

#include "drivers/registry.h"
#include "engine/app/cli/run_options.h"
#include "engine/app/run/program_faults.h"
#include "engine/app/run/results.h"
#include "engine/app/run/run_sink.h"
#include "engine/app/run/trial_results.h"
#include "engine/audio/player.h"

namespace fulcrum::app {

// Who trains, and what they are compared with.
struct Trainee {
  Participation* participation = nullptr;         // null: nobody's results are kept
  const session::TrialMetrics* expert = nullptr;  // null: nothing to compare with
};

// Of the pictures that somebody saw.
struct PictureFigures {
  std::optional<double> frames_per_s;
  std::optional<record::HandToPixel> hand_to_pixel;
  std::optional<record::Colocated> colocation{};  // of a headset
};

class RunSession {
public:
  // All must outlive it. What is wrong is on stderr, and null is returned.
  static std::unique_ptr<RunSession> begin(const Prepared& prepared, const RunOptions& options,
                                           const Trainee& trainee);

  World& world() { return world_; }
  OpenDevice& device() { return device_; }
  RunSink& sink() { return sink_; }
  // Before the run: it is heard, if the scenario names `sound` and there is a device for it. says_why_not: of
  // a device that is not there, a sentence on stderr; the run goes on in silence.
  void play_sound(bool says_why_not);
  audio::Player* player() { return player_.get(); }  // null: silence
  const ProgramFaults& faults() const { return faults_; }
  const std::filesystem::path& folder() const { return folder_.path; }

  // The program's exit code. Not of a run that is not recorded. plan: what was drawn with, if anything was.
  // person: one may acknowledge a stop, or leave; then no fault ended the run. figures: of what a window or
  // a headset showed.
  int finish(const render::RenderPlan* plan, bool person, const PictureFigures& figures = {});

private:
  RunSession(const Prepared& prepared, const RunOptions& options, const Trainee& trainee, OpenDevice device,
             World world, std::optional<OpenResults> results, double limit);

  const Prepared& prepared_;
  const RunOptions& options_;
  const Trainee& trainee_;
  std::chrono::system_clock::time_point began_ = std::chrono::system_clock::now();
  OpenDevice device_;
  World world_;
  record::RunFolder folder_;  // until all is written
  ProgramFaults faults_;
  RunSink sink_;
  std::unique_ptr<audio::Player> player_;
};

}  // namespace fulcrum::app
