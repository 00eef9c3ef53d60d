#include "engine/app/run/trial_results.h"

#include <sys/stat.h>

#include <algorithm>
#include <system_error>
#include <utility>

#include "engine/app/cli/terminal.h"
#include "engine/app/cli/version.h"
#include "engine/app/run/picture_age.h"
#include "engine/files/block_file.h"
#include "engine/record/run_folder.h"
#include "engine/session/identity.h"
#include "engine/session/trial_page.h"
#include "haptics/safety/faults.h"

namespace fulcrum::app {
namespace {

// Where a folder is, whatever links and working folder led to it.
std::string place_of(const std::filesystem::path& folder) {
  std::error_code failure;
  const std::filesystem::path place = std::filesystem::canonical(folder, failure);
  return failure ? std::filesystem::absolute(folder, failure).string() : place.string();
}

// As a shell takes it, whatever letters it has.
std::string quoted(const std::string& text) {
  std::string out = "'";
  for (const char c : text)
    if (c == '\'')
      out += "'\\''";
    else
      out += c;
  return out + "'";
}

// What --set has changed of the task. The device, the hand and the seed are no part of it.
std::string changes_of(const scenario::Scenario& scenario) {
  std::string changes;
  for (const std::string& change : scenario.overrides) {
    if (change.starts_with("device.") || change.starts_with("left_handed=") || change.starts_with("seed="))
      continue;
    if (!changes.empty()) changes += ' ';
    changes += change;
  }
  return changes;
}

session::Trial trial_of(const FinishedTrial& of) {
  const record::Summary& summary = of.summary;
  session::Trial trial;
  trial.uuid = session::random_uuid();
  trial.scenario = of.prepared.name;
  trial.title = of.prepared.scenario.title;
  trial.began = session::utc_text(of.began);
  trial.ended = session::utc_text(std::chrono::system_clock::now());
  trial.device = summary.device;
  trial.hand = summary.hand;
  trial.left_handed = summary.left_handed;
  trial.seed = summary.seed;
  trial.metrics = of.metrics;
  const double half_tick = 0.5 * summary.tick_s;
  const bool ended =
      trial.metrics.completed || trial.metrics.time + half_tick >= of.prepared.scenario.time_limit;
  trial.whole = ended && of.recorded;
  trial.changes = changes_of(of.prepared.scenario);
  trial.events = of.sink.meter().events();
  trial.folder = place_of(of.folder);
  trial.trace_sha256 = summary.trace_sha256.value_or("");
  return trial;
}

}  // namespace

Result<Participation> Participation::begin(const std::string& pseudonym) {
  if (std::optional<Error> refused = session::refuse_pseudonym(pseudonym)) return *std::move(refused);
  const Result<std::filesystem::path> file = session::Store::default_file();
  if (!file) return file.error();
  // From here on what the program writes is for its owner alone to read.
  ::umask(S_IRWXG | S_IRWXO);
  Result<session::Store> store = session::Store::open(*file);
  if (!store) return store.error();
  return Participation{
      std::move(*store),
      {session::random_uuid(), pseudonym, session::utc_text(std::chrono::system_clock::now()), kVersion}};
}

std::optional<EarlierTrials> earlier_trials(const Participation& participation, const Prepared& prepared) {
  if (!changes_of(prepared.scenario).empty()) return std::nullopt;
  const auto all = participation.store.trials({participation.session.participant, prepared.name});
  if (!all) return std::nullopt;
  EarlierTrials earlier;
  for (const session::StoredTrial& stored : *all) {
    const session::Trial& trial = stored.trial;
    if (!trial.whole || !trial.changes.empty() || trial.metrics.guided || !trial.score) continue;
    ++earlier.count;
    earlier.last = *trial.score;
    earlier.best = std::max(earlier.best, *trial.score);
  }
  return earlier.count > 0 ? std::optional(earlier) : std::nullopt;
}

session::Score score_of(const FinishedTrial& trial) {
  return session::score(trial.metrics, trial.expert, trial.prepared.haptic.task.score);
}

bool write_trial_page(const FinishedTrial& of, const std::string& participant) {
  const session::Trial trial = trial_of(of);
  const session::Score score = score_of(of);
  session::TrialPage page{.trial = trial,
                          .about = of.prepared.scenario.about,
                          .participant = participant,
                          .score = score,
                          .curves = of.sink.meter().curves(),
                          .hard_touch = of.prepared.haptic.task.hard_touch};
  if (of.expert != nullptr) page.expert_time = of.expert->time;
  const auto asked_for = std::ranges::find(fault_names(), kStopRequested, &FaultName::bit);
  for (const record::FaultCount& fault : of.summary.faults)
    if (fault.name != asked_for->name) page.faults.push_back(fault.sentence);
  for (const record::FaultCount& limit : of.summary.limits) page.limits.push_back(limit.sentence);
  if (of.summary.heard) page.heard = record::heard_text(*of.summary.heard);
  if (of.summary.hand_to_pixel) page.age = picture_age(*of.summary.hand_to_pixel);
  page.replay_command = "fulcrum replay " + quoted(trial.folder + "/" + std::string(record::kTapeName));
  const std::optional<Error> failure =
      write_new_file(of.folder / record::kReportName, session::trial_html(page));
  if (failure) complain(failure->sentence);
  return !failure;
}

bool keep_trial(const FinishedTrial& of, Participation& participation) {
  session::Trial trial = trial_of(of);
  trial.score = score_of(of).total;
  const std::optional<Error> failure = participation.store.add(participation.session, trial);
  if (failure)
    complain(failure->sentence + " This trial is not among the results; its recording is in " + trial.folder +
             ".");
  return !failure;
}

}  // namespace fulcrum::app
