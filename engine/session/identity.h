#pragma once
// What results are named by: pseudonyms, random identifiers, times.

#include <chrono>
#include <optional>
#include <string>
#include <string_view>

#include "haptics/math/result.h"

namespace fulcrum::session {

// Why the text cannot be a pseudonym: 1 to 64 letters of UTF-8, the first of them a letter or a digit, and
// none that is not seen or begins or ends with a space. Absent: it can.
std::optional<Error> refuse_pseudonym(std::string_view name);

// RFC 4122, version 4, from the system's generator.
std::string random_uuid();

// UTC to the millisecond, ISO 8601: 2026-11-25T09:03:00.000Z.
std::string utc_text(std::chrono::system_clock::time_point time);

}  // namespace fulcrum::session
