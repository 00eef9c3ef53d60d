#include "engine/session/store.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <string>
#include <system_error>

#include "engine/files/descriptor.h"
#include "engine/files/file_error.h"
#include "engine/files/user_folders.h"
#include "engine/session/schema.h"
#include "engine/session/sql.h"

namespace fulcrum::session {
namespace {

constexpr const char* kTrials =
    "SELECT trial.id, trial.uuid, scenario, title, trial.began, ended, device, hand, left_handed, seed, "
    "whole, "
    "guided, score, changes, folder, trace_sha256, session.uuid, participant.name, session.began, "
    "program_version "
    "FROM trial "
    "JOIN "
    "session ON session.id = trial.session JOIN participant ON participant.id = session.participant ";

StoredTrial read_trial(const sql::Statement& row) {
  StoredTrial stored;
  Trial& trial = stored.trial;
  int column = 1;
  for (std::string* text :
       {&trial.uuid, &trial.scenario, &trial.title, &trial.began, &trial.ended, &trial.device, &trial.hand})
    *text = row.text(column++);
  trial.left_handed = row.integer(column++) != 0;
  trial.seed = row.integer(column++);
  trial.whole = row.integer(column++) != 0;
  trial.metrics.guided = row.integer(column++) != 0;
  if (!row.is_null(column)) trial.score = row.number(column);
  ++column;
  for (std::string* text :
       {&trial.changes, &trial.folder, &trial.trace_sha256, &stored.session.uuid, &stored.session.participant,
        &stored.session.began, &stored.session.program_version})
    *text = row.text(column++);
  return stored;
}

TrialEvent::Kind kind_named(std::string_view name) {
  using Kind = TrialEvent::Kind;
  for (const Kind kind :
       {Kind::checkpoint, Kind::hard_touch, Kind::touch_on_the_way, Kind::slip, Kind::trespass, Kind::pause})
    if (name_of(kind) == name) return kind;
  return Kind::fault;
}

// Made for nobody but its owner: SQLite gives its other files the same rights. A file that is there is looked
// at by its place alone (O_PATH): once this process closes a descriptor of it, POSIX takes all its locks,
// SQLite's own included, and another program that ends would remove the log that a store of this process
// still writes.
std::optional<Error> make_file(const std::filesystem::path& file) {
  const int fresh = O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC | O_NOFOLLOW;
  if (!Descriptor(::open(file.c_str(), fresh, S_IRUSR | S_IWUSR)) && errno != EEXIST)
    return file_error("open", file, errno);
  const Descriptor place(::open(file.c_str(), O_PATH | O_CLOEXEC | O_NOFOLLOW));
  if (!place) return file_error("open", file, errno);
  struct stat status {};
  if (::fstat(place.number(), &status) != 0) return file_error("open", file, errno);
  if (!S_ISREG(status.st_mode))
    return Error{"The results in " + file.string() + " cannot be used: it is no file. Move it away."};
  return std::nullopt;
}

// One that was copied here may be open to others. Whose it is not says so itself when it is written.
void close_to_others(const std::filesystem::path& file) {
  const Descriptor place(::open(file.c_str(), O_PATH | O_CLOEXEC | O_NOFOLLOW));
  struct stat status {};
  if (!place || ::fstat(place.number(), &status) != 0 || (status.st_mode & (S_IRWXG | S_IRWXO)) == 0) return;
  ::chmod(("/proc/self/fd/" + std::to_string(place.number())).c_str(), S_IRUSR | S_IWUSR);
}

}  // namespace

class Store::Implementation {
public:
  explicit Implementation(const std::filesystem::path& file) : file_(file), database_(file) {}

  // What SQLite says, as a sentence with a remedy.
  Error error(const sql::Failure& failure) const {
    const std::string what = "The results in " + file_.string();
    switch (failure.code & 0xff) {
      case SQLITE_BUSY:
      case SQLITE_LOCKED:
        return {what + " are in use by another program: end it, and try again."};
      case SQLITE_NOTADB:
      case SQLITE_CORRUPT:
        return {what + " are damaged (" + failure.what() +
                "): move the file away, or bring one back from a backup."};
      case SQLITE_FULL:
        return {what + " cannot be written, since the disk is full: make room, and try again."};
      case SQLITE_IOERR:
        return {what + " cannot be used (" + failure.what() +
                "): make room if their disk is full, and look at the disk if it is not."};
      case SQLITE_READONLY:
      case SQLITE_PERM:
      case SQLITE_CANTOPEN:
        return {what + " cannot be written (" + failure.what() + "): make the file and its folder yours."};
      default:
        return {what + " cannot be used (" + failure.what() + "): look at the file and its disk."};
    }
  }

  // What `use` returns, or what went wrong in it.
  template <class Use>
  auto guarded(Use&& use) -> Result<decltype(use(std::declval<sql::Database&>()))> {
    try {
      return use(database_);
    } catch (const sql::Failure& failure) {
      return error(failure);
    }
  }

  // Nothing of a file is changed before it is known to be one of ours that this program knows.
  std::optional<Error> prepare() {
    const Result<bool> ours = guarded([](sql::Database& database) {
      const sql::Transaction view(database, "BEGIN");
      return is_store(database);
    });
    if (!ours) return ours.error();
    if (!*ours)
      return Error{"The database in " + file_.string() +
                   " is not one of Fulcrum's, and nothing is written into it: move it away."};
    const Result<std::int64_t> version =
        guarded([](sql::Database& database) { return schema_version(database); });
    if (!version) return version.error();
    if (*version > kSchemaVersion || *version < 0)
      return Error{"The results in " + file_.string() + " are of version " + std::to_string(*version) +
                   ", and this program knows up to " + std::to_string(kSchemaVersion) +
                   ": use the newer program that made them."};
    close_to_others(file_);
    const Result<bool> prepared = guarded([](sql::Database& database) {
      database.run(
          "PRAGMA journal_mode = WAL; PRAGMA synchronous = FULL; PRAGMA foreign_keys = ON; "
          "PRAGMA secure_delete = ON;");
      migrate(database);
      return true;
    });
    return prepared ? std::nullopt : std::optional(prepared.error());
  }

  // Folders below the store's own are kept as the way from it, so that all may be moved together.
  std::string kept_folder(const std::string& folder) const {
    const std::filesystem::path way = std::filesystem::path(folder).lexically_relative(file_.parent_path());
    const bool below = !way.empty() && *way.begin() != "..";
    return below ? way.string() : folder;
  }

  void fill(StoredTrial& stored, std::int64_t id, sql::Database& database) const {
    std::vector<std::pair<std::string, double>> values;
    sql::Statement metrics = database.prepare("SELECT name, value FROM metric WHERE trial = ?");
    metrics.bind(id);
    while (metrics.step()) values.emplace_back(metrics.text(0), metrics.number(1));
    const bool guided = stored.trial.metrics.guided;  // a column of the trial's own
    stored.trial.metrics = from_named_values(values);
    stored.trial.metrics.guided = guided;
    sql::Statement events =
        database.prepare("SELECT time_s, kind, text FROM event WHERE trial = ? ORDER BY number");
    events.bind(id);
    while (events.step())
      stored.trial.events.push_back({events.number(0), kind_named(events.text(1)), events.text(2)});
  }

  Result<std::vector<StoredTrial>> query(const std::string& text, const std::vector<std::string>& values) {
    return guarded([&](sql::Database& database) {
      const sql::Transaction view(database, "BEGIN");
      std::vector<StoredTrial> all;
      sql::Statement rows = database.prepare(text);
      for (const std::string& value : values) rows.bind(value);
      while (rows.step()) {
        all.push_back(read_trial(rows));
        std::string& folder = all.back().trial.folder;
        folder = (file_.parent_path() / folder).string();
        fill(all.back(), rows.integer(0), database);
      }
      return all;
    });
  }

private:
  std::filesystem::path file_;
  sql::Database database_;
};

Result<std::filesystem::path> Store::default_file() {
  const std::filesystem::path folder = data_folder();
  if (folder.empty())
    return Error{"Neither XDG_DATA_HOME nor HOME names a folder for the results: set one of them."};
  return folder / "results.sqlite";
}

Result<Store> Store::open(const std::filesystem::path& named) {
  std::error_code failed;
  std::filesystem::create_directories(named.parent_path(), failed);
  if (failed) return file_error("create", named.parent_path(), failed.value());
  // Links on the way to the folder are followed; the file itself is none.
  const std::filesystem::path folder = std::filesystem::canonical(named.parent_path(), failed);
  if (failed) return file_error("open", named.parent_path(), failed.value());
  const std::filesystem::path file = folder / named.filename();
  if (std::optional<Error> failure = make_file(file)) return *std::move(failure);
  try {
    auto implementation = std::make_unique<Implementation>(file);
    if (std::optional<Error> failure = implementation->prepare()) return *std::move(failure);
    return Store(std::move(implementation));
  } catch (const sql::Failure& failure) {
    return Error{"The results in " + file.string() + " cannot be opened (" + failure.what() +
                 "): make the file and its folder yours."};
  }
}

Store::Store(std::unique_ptr<Implementation> implementation) : implementation_(std::move(implementation)) {}
Store::Store(Store&&) noexcept = default;
Store& Store::operator=(Store&&) noexcept = default;
Store::~Store() = default;

std::optional<Error> Store::add(const Session& session, const Trial& trial) {
  const auto kept_folder = [this](const std::string& folder) { return implementation_->kept_folder(folder); };
  const Result<bool> added = implementation_->guarded([&](sql::Database& database) {
    sql::Transaction all(database);
    database.prepare("INSERT OR IGNORE INTO participant (name, since) VALUES (?, ?)")
        .bind(session.participant)
        .bind(session.began)
        .run();
    database
        .prepare(
            "INSERT OR IGNORE INTO session (uuid, participant, began, program_version) "
            "SELECT ?, id, ?, ? FROM participant WHERE name = ?")
        .bind(session.uuid)
        .bind(session.began)
        .bind(session.program_version)
        .bind(session.participant)
        .run();
    database
        .prepare(
            "INSERT INTO trial (session, uuid, scenario, title, began, ended, device, hand, left_handed, "
            "seed, "
            "whole, guided, score, changes, folder, trace_sha256) "
            "SELECT id, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ? FROM session WHERE uuid = ?")
        .bind(trial.uuid)
        .bind(trial.scenario)
        .bind(trial.title)
        .bind(trial.began)
        .bind(trial.ended)
        .bind(trial.device)
        .bind(trial.hand)
        .bind(std::int64_t{trial.left_handed})
        .bind(trial.seed)
        .bind(std::int64_t{trial.whole})
        .bind(std::int64_t{trial.metrics.guided})
        .bind(trial.score)
        .bind(trial.changes)
        .bind(kept_folder(trial.folder))
        .bind(trial.trace_sha256)
        .bind(session.uuid)
        .run();
    const std::int64_t id = database.integer("SELECT last_insert_rowid()");
    sql::Statement metric = database.prepare("INSERT INTO metric (trial, name, value) VALUES (?, ?, ?)");
    for (const auto& [name, value] : named_values(trial.metrics)) {
      metric.bind(id).bind(name).bind(value).run();
      metric.reset();
    }
    sql::Statement event =
        database.prepare("INSERT INTO event (trial, number, time_s, kind, text) VALUES (?, ?, ?, ?, ?)");
    std::int64_t number = 0;
    for (const TrialEvent& happened : trial.events) {
      event.bind(id)
          .bind(number++)
          .bind(happened.time)
          .bind(name_of(happened.kind))
          .bind(happened.text)
          .run();
      event.reset();
    }
    all.commit();
    return true;
  });
  if (!added) return added.error();
  return std::nullopt;
}

Result<std::vector<Participant>> Store::participants() const {
  return implementation_->guarded([](sql::Database& database) {
    std::vector<Participant> all;
    sql::Statement rows = database.prepare(
        "SELECT name, consents, since, (SELECT COUNT(*) FROM trial JOIN session ON session.id = "
        "trial.session "
        "WHERE session.participant = participant.id) FROM participant ORDER BY name");
    while (rows.step()) all.push_back({rows.text(0), rows.integer(1) != 0, rows.text(2), rows.integer(3)});
    return all;
  });
}

Result<std::vector<StoredTrial>> Store::trials(const Filter& filter) const {
  return implementation_->query(std::string(kTrials) +
                                    "WHERE (?1 = '' OR participant.name = ?1) AND (?2 = '' OR scenario = ?2) "
                                    "ORDER BY trial.began, trial.id",
                                {filter.participant, filter.scenario});
}

Result<std::optional<double>> Store::best_score(const std::string& participant,
                                                const std::string& scenario) const {
  return implementation_->guarded([&](sql::Database& database) {
    sql::Statement best = database.prepare(
        "SELECT MAX(score) FROM trial JOIN session ON session.id = trial.session JOIN participant ON "
        "participant.id = session.participant WHERE participant.name = ? AND scenario = ? AND whole = 1 "
        "AND changes = '' AND guided = 0 AND hand = ''");
    best.bind(participant).bind(scenario);
    std::optional<double> score;
    if (best.step() && !best.is_null(0)) score = best.number(0);
    return score;
  });
}

Result<bool> Store::set_consent(const std::string& participant, bool consents) {
  return implementation_->guarded([&](sql::Database& database) {
    database.prepare("UPDATE participant SET consents = ? WHERE name = ?")
        .bind(std::int64_t{consents})
        .bind(participant)
        .run();
    return database.integer("SELECT changes()") > 0;
  });
}

namespace {

constexpr const char* kToSend =
    "participant.consents = 1 AND whole = 1 AND changes = '' AND guided = 0 AND NOT EXISTS (SELECT 1 FROM "
    "sent WHERE "
    "sent.trial = trial.id "
    "AND "
    "sent.url = ?1)";

}  // namespace

Result<std::vector<StoredTrial>> Store::unsent(const std::string& url) const {
  return implementation_->query(std::string(kTrials) + "WHERE " + kToSend + " ORDER BY trial.began, trial.id",
                                {url});
}

Result<bool> Store::may_send(const std::string& trial_uuid, const std::string& url) const {
  return implementation_->guarded([&](sql::Database& database) {
    sql::Statement one = database.prepare(
        std::string("SELECT 1 FROM trial JOIN session ON session.id = trial.session JOIN participant ON "
                    "participant.id = session.participant WHERE trial.uuid = ?2 AND ") +
        kToSend);
    one.bind(url).bind(trial_uuid);
    return one.step();
  });
}

std::optional<Error> Store::mark_sent(const std::string& trial_uuid, const std::string& url,
                                      const std::string& at) {
  const Result<bool> marked = implementation_->guarded([&](sql::Database& database) {
    database.prepare("INSERT OR IGNORE INTO sent (trial, url, at) SELECT id, ?, ? FROM trial WHERE uuid = ?")
        .bind(url)
        .bind(at)
        .bind(trial_uuid)
        .run();
    return true;
  });
  if (!marked) return marked.error();
  return std::nullopt;
}

Result<Store::Removal> Store::remove_participant(const std::string& participant,
                                                 const std::vector<std::string>& trial_uuids) {
  return implementation_->guarded([&](sql::Database& database) {
    {
      sql::Transaction all(database);
      sql::Statement trials = database.prepare(
          "SELECT trial.uuid FROM trial JOIN session ON session.id = trial.session JOIN participant ON "
          "participant.id = session.participant WHERE participant.name = ?");
      trials.bind(participant);
      while (trials.step())
        if (std::ranges::find(trial_uuids, trials.text(0)) == trial_uuids.end()) return Removal::more_trials;
      trials.reset();
      database.prepare("DELETE FROM participant WHERE name = ?").bind(participant).run();
      all.commit();
    }
    // What the log of writes still holds of them goes too. A reader keeps it for as long as it reads.
    sql::Statement checkpoint = database.prepare("PRAGMA wal_checkpoint(TRUNCATE)");
    const bool whole = checkpoint.step() && checkpoint.integer(0) == 0;
    return whole ? Removal::done : Removal::still_read;
  });
}

}  // namespace fulcrum::session
