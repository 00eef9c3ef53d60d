#pragma once
// What a finished trial leaves for people: its score, its page, and its place among a participant's results.

#include <chrono>
#include <filesystem>
#include <optional>
#include <string>

#include "engine/app/prepare/prepare.h"
#include "engine/app/run/run_sink.h"
#include "engine/session/score.h"
#include "engine/session/store.h"

namespace fulcrum::app {

// Whose trials these are: one start of the program.
struct Participation {
  session::Store store;
  session::Session session;

  // Errors: the pseudonym cannot be one, or results cannot be kept.
  static Result<Participation> begin(const std::string& pseudonym);
};

// A participant's trials of a scenario before: whole ones without guidance and changes, which alone compare.
struct EarlierTrials {
  std::size_t count = 0;
  double best = 0, last = 0;  // points
};
// None where there are none, or the results cannot be read.
std::optional<EarlierTrials> earlier_trials(const Participation& participation, const Prepared& prepared);

struct FinishedTrial {
  const Prepared& prepared;
  const RunSink& sink;
  session::TrialMetrics metrics;   // of the sink
  const record::Summary& summary;  // with device and hand
  std::filesystem::path folder;
  std::chrono::system_clock::time_point began;
  const session::TrialMetrics* expert = nullptr;  // null: nothing to compare with
  bool recorded = true;                           // all of it
};

// report.html in the trial's folder. False: it could not be written, and a sentence on stderr said so.
bool write_trial_page(const FinishedTrial& trial, const std::string& participant);

// The same for its row among the results, which is on disk when this returns.
bool keep_trial(const FinishedTrial& trial, Participation& participation);

session::Score score_of(const FinishedTrial& trial);

}  // namespace fulcrum::app
