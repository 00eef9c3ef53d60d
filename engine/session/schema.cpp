#include "engine/session/schema.h"

#include <string>

#include "engine/session/identity.h"

namespace fulcrum::session {
namespace {

constexpr const char* kVersion1 = R"(
CREATE TABLE participant (id INTEGER PRIMARY KEY, name TEXT NOT NULL UNIQUE, consents INTEGER NOT NULL DEFAULT 0,
  since TEXT NOT NULL);
CREATE TABLE session (id INTEGER PRIMARY KEY, uuid TEXT NOT NULL UNIQUE,
  participant INTEGER NOT NULL REFERENCES participant(id) ON DELETE CASCADE, began TEXT NOT NULL,
  program_version TEXT NOT NULL);
CREATE TABLE trial (id INTEGER PRIMARY KEY, session INTEGER NOT NULL REFERENCES session(id) ON DELETE CASCADE,
  scenario TEXT NOT NULL, title TEXT NOT NULL, began TEXT NOT NULL, ended TEXT NOT NULL, device TEXT NOT NULL,
  hand TEXT NOT NULL, left_handed INTEGER NOT NULL, seed INTEGER NOT NULL, whole INTEGER NOT NULL, score REAL,
  folder TEXT NOT NULL, trace_sha256 TEXT NOT NULL);
CREATE TABLE metric (trial INTEGER NOT NULL REFERENCES trial(id) ON DELETE CASCADE, name TEXT NOT NULL,
  value REAL NOT NULL, PRIMARY KEY (trial, name)) WITHOUT ROWID;
CREATE TABLE event (trial INTEGER NOT NULL REFERENCES trial(id) ON DELETE CASCADE, number INTEGER NOT NULL,
  time_s REAL NOT NULL, kind TEXT NOT NULL, text TEXT NOT NULL, PRIMARY KEY (trial, number)) WITHOUT ROWID;
CREATE INDEX session_participant ON session(participant);
CREATE INDEX trial_session ON trial(session);
)";

// A trial has a name of its own, by which a learning record store knows it; what was changed of its task, and
// what was sent, is noted.
constexpr const char* kVersion2 = R"(
ALTER TABLE trial ADD COLUMN uuid TEXT NOT NULL DEFAULT '';
ALTER TABLE trial ADD COLUMN changes TEXT NOT NULL DEFAULT '';
CREATE TABLE sent (trial INTEGER NOT NULL REFERENCES trial(id) ON DELETE CASCADE, url TEXT NOT NULL, at TEXT NOT NULL,
  PRIMARY KEY (trial, url)) WITHOUT ROWID;
CREATE INDEX trial_folder ON trial(folder);
)";

// Whether the person was led in a trial. None was before there was this column.
constexpr const char* kVersion3 = "ALTER TABLE trial ADD COLUMN guided INTEGER NOT NULL DEFAULT 0";

void name_trials(sql::Database& database) {
  sql::Statement unnamed = database.prepare("SELECT id FROM trial WHERE uuid = ''");
  sql::Statement name = database.prepare("UPDATE trial SET uuid = ? WHERE id = ?");
  while (unnamed.step()) {
    name.bind(random_uuid()).bind(unnamed.integer(0)).run();
    name.reset();
  }
  database.run("CREATE UNIQUE INDEX trial_uuid ON trial(uuid)");
}

}  // namespace

std::int64_t schema_version(sql::Database& database) {
  return database.integer("PRAGMA user_version");
}

// A store has the tables of version 1, and names no program in application_id.
bool is_store(sql::Database& database) {
  const std::int64_t tables = database.integer("SELECT count(*) FROM sqlite_master WHERE type = 'table'");
  const std::int64_t own = database.integer(
      "SELECT count(*) FROM sqlite_master WHERE type = 'table' AND name IN "
      "('participant', 'session', 'trial', 'metric', 'event')");
  const std::int64_t application = database.integer("PRAGMA application_id");
  if (application != 0) return false;
  return schema_version(database) == 0 ? tables == 0 : own == 5;
}

void migrate(sql::Database& database, std::int64_t to) {
  if (schema_version(database) == to) return;
  sql::Transaction all(database);
  std::int64_t version = schema_version(database);
  if (version < 1 && to >= 1) {
    database.run(kVersion1);
    version = 1;
  }
  if (version < 2 && to >= 2) {
    database.run(kVersion2);
    name_trials(database);
    version = 2;
  }
  if (version < 3 && to >= 3) {
    database.run(kVersion3);
    version = 3;
  }
  database.run(("PRAGMA user_version = " + std::to_string(version)).c_str());
  all.commit();
}

}  // namespace fulcrum::session
