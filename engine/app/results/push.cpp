#include "engine/app/results/push.h"

#include <chrono>
#include <cstdio>
#include <vector>

#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/interrupt.h"
#include "engine/app/cli/terminal.h"
#include "engine/session/identity.h"
#include "engine/session/record_store.h"
#include "engine/session/xapi.h"

namespace fulcrum::app {
namespace {

session::Statement statement_of(const session::StoredTrial& stored) {
  const session::Trial& trial = stored.trial;
  session::Statement statement;
  statement.uuid = trial.uuid;
  statement.participant = stored.session.participant;
  statement.session_uuid = stored.session.uuid;
  statement.scenario = trial.scenario;
  statement.scenario_title = trial.title;
  statement.ended_utc = trial.ended;
  statement.duration_s = trial.metrics.time;
  statement.completed = trial.metrics.completed;
  statement.score = trial.score;
  statement.metrics = named_values(trial.metrics);
  statement.program_version = stored.session.program_version;
  statement.device = trial.device;
  statement.hand = trial.hand;
  statement.left_handed = trial.left_handed;
  return statement;
}

struct Counts {
  std::size_t sent = 0, refused = 0, waiting = 0;
};

int told(const Counts& counts) {
  std::printf("%zu sent", counts.sent);
  if (counts.refused > 0) std::printf(", %zu refused", counts.refused);
  if (counts.waiting > 0) std::printf(", %zu waiting: give the same command again later", counts.waiting);
  std::printf(".\n");
  return counts.refused + counts.waiting > 0 ? kError : kCompleted;
}

}  // namespace

int push_results(session::Store& store, const PushOptions& options) {
  using Kind = session::PutOutcome::Kind;
  std::optional<std::filesystem::path> certificates;  // none: the system's
  if (!options.certificates.empty()) certificates = options.certificates;
  Result<session::RecordStore> keeper =
      session::RecordStore::open(options.url, options.credentials, certificates);
  if (!keeper) {
    complain(keeper.error().sentence);
    return kError;
  }
  const std::string& url = keeper->address();
  const Result<std::vector<session::StoredTrial>> waiting = store.unsent(url);
  if (!waiting) {
    complain(waiting.error().sentence);
    return kError;
  }
  catch_interrupts();
  Counts counts{.waiting = waiting->size()};
  ProgressBar bar;
  for (const session::StoredTrial& stored : *waiting) {
    bar.show("Sending", static_cast<double>(counts.sent) / static_cast<double>(waiting->size()));
    // Somebody may have withdrawn, or another program may have sent it meanwhile.
    const Result<bool> still = store.may_send(stored.trial.uuid, url);
    if (!still) {
      complain(still.error().sentence);
      return kError;
    }
    if (!*still) {
      --counts.waiting;
      continue;
    }
    const Result<session::PutOutcome> put = keeper->put(
        stored.trial.uuid, statement_json(statement_of(stored), url), [] { return interrupted(); });
    if (!put) {
      bar.clear();
      complain(put.error().sentence);
      return told(counts);
    }
    switch (put->kind) {
      case Kind::stored:
      case Kind::already_there:
        if (const auto failure = store.mark_sent(stored.trial.uuid, url,
                                                 session::utc_text(std::chrono::system_clock::now()))) {
          complain(failure->sentence);
          return kError;
        }
        ++counts.sent;
        --counts.waiting;
        break;
      case Kind::refused:
        bar.clear();
        complain(put->why);
        ++counts.refused;
        --counts.waiting;
        break;
      case Kind::try_again:
      case Kind::stopped:
        bar.clear();
        if (!put->why.empty()) complain(put->why);
        return told(counts);
    }
  }
  bar.clear();
  return told(counts);
}

}  // namespace fulcrum::app
