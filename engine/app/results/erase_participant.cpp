#include "engine/app/results/erase_participant.h"

#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>
#include <system_error>
#include <vector>

#include "engine/app/cli/terminal.h"
#include "engine/assets/sha256.h"
#include "engine/files/file_error.h"
#include "engine/files/regular_file.h"
#include "engine/record/run_folder.h"

namespace fulcrum::app {
namespace {

namespace fs = std::filesystem;

constexpr std::uint64_t kMostOfASummary = 1 << 22;
constexpr int kMostRounds = 10;

// The trace's hash, as the folder's summary has it; empty: it has none.
std::string hash_in_summary(const fs::path& folder) {
  const Result<RegularFile> file = RegularFile::open(folder / record::kSummaryName);
  if (!file) return {};
  const Result<std::string> bytes = file->first_bytes(kMostOfASummary);
  if (!bytes) return {};
  const nlohmann::json summary = nlohmann::json::parse(*bytes, nullptr, false);
  if (!summary.is_object()) return {};
  const auto hash = summary.find("trace_sha256");
  return hash != summary.end() && hash->is_string() ? hash->get<std::string>() : std::string();
}

std::string hash_of_trace(const fs::path& folder) {
  Result<RegularFile> file = RegularFile::open(folder / record::kTraceName);
  const Result<std::string> hash = file ? sha256_hex(std::move(*file)) : file.error();
  return hash ? *hash : std::string();
}

enum class Holds { this_trial, another, no_folder, nobody_knows };

// Whether the folder is the one that the trial wrote into: by the hash of its trace, which the results keep,
// its summary says and the trace has. The summary is the last file to be removed, so that what an interrupted
// deletion has left is known for what it is.
Holds what_is_in(const fs::path& folder, const session::Trial& trial) {
  std::error_code failure;
  const fs::file_status status = fs::status(folder, failure);
  if (status.type() == fs::file_type::not_found) {
    // A link that leads nowhere may lead to a disk that is not there now.
    for (fs::path way = folder; way.has_relative_path(); way = way.parent_path()) {
      std::error_code unknown;
      if (!fs::is_symlink(way, unknown) || fs::exists(way, unknown)) continue;
      complain("the link " + way.string() + " leads nowhere: bring its disk back, or remove the link.");
      return Holds::nobody_knows;
    }
    return Holds::no_folder;
  }
  if (failure) {
    complain(file_error("look into", folder, failure.value()).sentence);
    return Holds::nobody_knows;
  }
  if (status.type() != fs::file_type::directory) return Holds::another;
  const std::string said = hash_in_summary(folder);
  if (!trial.trace_sha256.empty() &&
      (said == trial.trace_sha256 || hash_of_trace(folder) == trial.trace_sha256))
    return Holds::this_trial;
  if (!said.empty()) return Holds::another;
  const Result<std::size_t> left = record::count_results(folder);
  if (left && *left == 0) return Holds::no_folder;
  complain("nobody can tell whether what is in " + folder.string() +
           " is a trial of theirs, since its trace and its "
           "summary are not there: look, and remove it or bring them back.");
  return Holds::nobody_knows;
}

// False: a file is left, and a sentence said which.
bool erase_folder(const session::Trial& trial, std::size_t& files) {
  // Whoever moves recordings to a larger disk leaves a link behind: what counts is what lies there.
  std::error_code gone;
  const fs::path followed = fs::canonical(trial.folder, gone);
  const fs::path folder = gone ? fs::path(trial.folder) : followed;
  switch (what_is_in(folder, trial)) {
    case Holds::no_folder:
      complain("there is no recording in " + trial.folder +
               " any more: if it was moved, it is for you to delete.");
      return true;
    case Holds::nobody_knows:
      return false;
    case Holds::another:
      complain(
          "the folder " + trial.folder +
          " holds something else than the trial that was written there, and is left as it is: look whether "
          "it is theirs.");
      return true;
    case Holds::this_trial:
      break;
  }
  const Result<std::size_t> removed = record::remove_results(folder);
  if (!removed) {
    complain(removed.error().sentence);
    return false;
  }
  files += *removed;
  std::error_code not_empty;
  fs::remove(folder, not_empty);  // of what else lies in it nobody but its owner knows
  return true;
}

}  // namespace

Result<Erased> erase_participant(session::Store& store, const std::string& participant) {
  using Removal = session::Store::Removal;
  Erased erased;
  // Trials may end while this goes on: then all is looked at again.
  for (int round = 0; round < kMostRounds; ++round) {
    const Result<std::vector<session::StoredTrial>> all = store.trials({});
    if (!all) return all.error();
    std::set<std::string> of_others;  // folders
    for (const session::StoredTrial& stored : *all)
      if (stored.session.participant != participant) of_others.insert(stored.trial.folder);
    std::vector<std::string> uuids;
    for (const session::StoredTrial& stored : *all) {
      if (stored.session.participant != participant) continue;
      uuids.push_back(stored.trial.uuid);
      if (of_others.contains(stored.trial.folder)) continue;  // it was written anew, by somebody else
      if (!erase_folder(stored.trial, erased.files)) erased.whole = false;
    }
    erased.trials = uuids.size();
    if (!erased.whole) return erased;
    const Result<Removal> removed = store.remove_participant(participant, uuids);
    if (!removed) return removed.error();
    if (*removed == Removal::more_trials) continue;
    erased.still_read = *removed == Removal::still_read;
    return erased;
  }
  complain("trial after trial of " + participant + " ended meanwhile: end the programs in which they train.");
  erased.whole = false;
  return erased;
}

}  // namespace fulcrum::app
