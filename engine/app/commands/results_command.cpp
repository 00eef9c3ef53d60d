#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iostream>
#include <memory>
#include <string>
#include <system_error>

#include "engine/app/cli/exit_code.h"
#include "engine/app/cli/report_output.h"
#include "engine/app/cli/terminal.h"
#include "engine/app/commands/commands.h"
#include "engine/app/results/erase_participant.h"
#include "engine/app/results/push.h"
#include "engine/app/results/table.h"
#include "engine/app/start/start_settings.h"
#include "engine/files/block_file.h"
#include "engine/session/history_page.h"
#include "engine/session/store.h"

namespace fulcrum::app {
namespace {

struct ResultsOptions {
  session::Filter filter;
  bool participants = false, json = false, yes = false;
  std::string csv, page;                     // files to write
  std::string consents, withdraws, deletes;  // participants
  PushOptions push;
};

int refuse(const Error& error) {
  complain(error.sentence);
  return kError;
}

int unknown(const std::string& participant) {
  complain("there is no participant '" + participant + "': `fulcrum results --participants` lists them.");
  return kError;
}

Result<bool> is_known(const session::Store& store, const std::string& participant) {
  const Result<std::vector<session::Participant>> all = store.participants();
  if (!all) return all.error();
  return std::ranges::find(*all, participant, &session::Participant::name) != all->end();
}

int list_participants(const session::Store& store) {
  const Result<std::vector<session::Participant>> all = store.participants();
  if (!all) return refuse(all.error());
  report::Table table{{"participant", "trials", "may be sent", "since (UTC)"}, {}};
  for (const session::Participant& one : *all)
    table.rows.push_back(
        {one.name, std::to_string(one.trials), one.consents ? "yes" : "no", one.since.substr(0, 10)});
  if (all->empty())
    std::printf(
        "There are no participants yet: `fulcrum run NAME --participant PSEUDONYM` keeps a result.\n");
  else
    print_table(table);
  return kCompleted;
}

int set_consent(session::Store& store, const std::string& participant, bool consents) {
  const Result<bool> known = store.set_consent(participant, consents);
  if (!known) return refuse(known.error());
  if (!*known) return unknown(participant);
  std::printf(consents
                  ? "%s consents: results may be sent.\n"
                  : "%s has withdrawn: nothing more is sent. What a record store has is for its keeper to "
                    "remove.\n",
              participant.c_str());
  return kCompleted;
}

// Asked for on a terminal; without one, --yes is the only word for it.
bool confirmed(const std::string& question, bool yes) {
  if (yes) return true;
  if (::isatty(STDIN_FILENO) == 0) return false;
  std::printf("%s Type yes: ", question.c_str());
  std::fflush(stdout);
  std::string answer;
  std::getline(std::cin, answer);
  return answer == "yes";
}

int delete_participant(session::Store& store, const std::string& participant, bool yes) {
  const Result<bool> known = is_known(store, participant);
  if (!known) return refuse(known.error());
  if (!*known) return unknown(participant);
  if (!confirmed("All results of " + participant + ", with their recordings, are deleted for good.", yes)) {
    complain("nothing was deleted. Without a terminal, --yes says that it is meant.");
    return kUsage;
  }
  if (const std::optional<Error> failure = forget_start_participant(participant)) {
    complain("nothing was deleted, since " + start_file().string() + " names " + participant + ". " +
             failure->sentence + " Then give this command again.");
    return kError;
  }
  const Result<Erased> erased = erase_participant(store, participant);
  if (!erased) return refuse(erased.error());
  if (!erased->whole) {
    complain("not all of it could be deleted, so " + participant +
             " is still among the results: mend what is said above, and give this command again.");
    return kError;
  }
  std::printf("Deleted: %s, %zu trials, %zu files.\n", participant.c_str(), erased->trials, erased->files);
  if (erased->still_read)
    complain(
        "another program reads the results right now: until it ends, the file's log holds what was deleted.");
  return kCompleted;
}

int write(const std::string& file, const std::string& content) {
  std::error_code unknown;
  if (std::filesystem::exists(std::filesystem::symlink_status(file, unknown))) {
    complain("'" + file + "' is there already: name a new file, or remove it first.");
    return kError;
  }
  if (const std::optional<Error> failure = write_new_file(file, content)) return refuse(*failure);
  std::printf("%s\n", file.c_str());
  return kCompleted;
}

int show_trials(const session::Store& store, const ResultsOptions& options) {
  if (!options.filter.participant.empty()) {
    const Result<bool> known = is_known(store, options.filter.participant);
    if (!known) return refuse(known.error());
    if (!*known) return unknown(options.filter.participant);
  }
  const Result<std::vector<session::StoredTrial>> trials = store.trials(options.filter);
  if (!trials) return refuse(trials.error());
  if (!options.csv.empty()) return write(options.csv, results_csv(*trials));
  if (!options.page.empty()) return write(options.page, session::history_html(*trials));
  if (options.json)
    std::fputs(results_json(*trials).c_str(), stdout);
  else if (trials->empty())
    std::printf("There are no results%s: `fulcrum run NAME --participant PSEUDONYM` keeps one.\n",
                options.filter.scenario.empty() ? " yet" : " of that scenario");
  else
    print_table(results_table(*trials));
  return kCompleted;
}

int results_command(const ResultsOptions& options) {
  int actions = options.participants ? 1 : 0;
  for (const std::string* action : {&options.csv, &options.page, &options.consents, &options.withdraws,
                                    &options.deletes, &options.push.url})
    if (!action->empty()) ++actions;
  if (actions + (options.json ? 1 : 0) > 1) {
    complain(
        "`fulcrum results` does one thing at a time: give one of --participants, --csv, --page, --json, "
        "--consents, --withdraws, --delete-participant and --push.");
    return kUsage;
  }
  const bool acts = options.participants || !options.consents.empty() || !options.withdraws.empty() ||
                    !options.deletes.empty() || !options.push.url.empty();
  if (acts && (!options.filter.participant.empty() || !options.filter.scenario.empty())) {
    complain(
        "--participant and --scenario choose what is listed, written by --csv or --page, or printed as JSON; "
        "leave them out here.");
    return kUsage;
  }
  if ((options.yes && options.deletes.empty()) ||
      (!options.push.certificates.empty() && options.push.url.empty())) {
    complain("--yes belongs to --delete-participant, and --certificates to --push: leave them out here.");
    return kUsage;
  }
  if (options.push.url.empty() != options.push.credentials.empty()) {
    complain(
        "--push URL and --credentials FILE belong together: the file's first line is USER:PASSWORD, and "
        "nobody "
        "else may read it.");
    return kUsage;
  }
  const Result<std::filesystem::path> file = session::Store::default_file();
  if (!file) return refuse(file.error());
  Result<session::Store> store = session::Store::open(*file);
  if (!store) return refuse(store.error());
  if (options.participants) return list_participants(*store);
  if (!options.consents.empty()) return set_consent(*store, options.consents, true);
  if (!options.withdraws.empty()) return set_consent(*store, options.withdraws, false);
  if (!options.deletes.empty()) return delete_participant(*store, options.deletes, options.yes);
  if (!options.push.url.empty()) return push_results(*store, options.push);
  return show_trials(*store, options);
}

}  // namespace

void add_results(Program& program) {
  const auto options = std::make_shared<ResultsOptions>();
  program.add(
      "results", "Trials of participants: list, export, send, delete",
      [options](Arguments& arguments) {
        arguments.text({"--participant", "PSEUDONYM", "Their trials alone"}, options->filter.participant);
        arguments.text({"--scenario", "NAME", "Trials of that scenario alone"}, options->filter.scenario);
        arguments.flag("--participants", "List the participants", options->participants);
        arguments.text({"--csv", "FILE", "Write the trials as a table, a new file"}, options->csv);
        arguments.text({"--page", "FILE", "Write learning curves as an HTML page, a new file"},
                       options->page);
        arguments.text({"--consents", "PSEUDONYM", "This participant's results may be sent"},
                       options->consents);
        arguments.text({"--withdraws", "PSEUDONYM", "This participant's results may not be sent any more"},
                       options->withdraws);
        arguments.text({"--delete-participant", "PSEUDONYM",
                        "Delete every trace of this participant, recordings included"},
                       options->deletes);
        arguments.flag("--yes", "Delete without asking", options->yes);
        arguments.text(
            {"--push", "URL", "Send what may be sent to a learning record store (xAPI), each result once"},
            options->push.url);
        arguments.text({"--credentials", "FILE", "For --push: USER:PASSWORD, in a file of mode 600"},
                       options->push.credentials);
        arguments.text(
            {"--certificates", "FILE", "For --push: PEM of the store's authority (default: the system's)"},
            options->push.certificates);
        arguments.json("As JSON", options->json);
      },
      [options] { return results_command(*options); });
}

}  // namespace fulcrum::app
