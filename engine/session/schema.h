#pragma once
// What the tables of results look like, and how those of an older version become that.

#include "engine/session/sql.h"

namespace fulcrum::session {

inline constexpr std::int64_t kSchemaVersion = 3;

// Of a store that is there; 0: it has no tables yet.
std::int64_t schema_version(sql::Database& database);

// Whether it is a store of whichever version, or has nothing in it yet: another program's is neither.
bool is_store(sql::Database& database);

// From whichever version to `to`, in one transaction; throws sql::Failure. Another program may have done it
// meanwhile.
void migrate(sql::Database& database, std::int64_t to = kSchemaVersion);

}  // namespace fulcrum::session
