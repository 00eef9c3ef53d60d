#pragma once
// Who we are to a learning record store, in a file that nobody else can read.

#include <filesystem>
#include <string>

#include "haptics/math/result.h"

namespace fulcrum::session {

struct Credentials {
  std::string user{};
  std::string password{};
};

// The file's first line is USER:PASSWORD. It is refused unless it is a file of this user's own with mode 600
// or less, since what others could read is no secret any more. No sentence repeats what it says.
Result<Credentials> read_credentials(const std::filesystem::path& path);

}  // namespace fulcrum::session
