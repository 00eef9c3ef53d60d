#include "engine/files/config_folder.h"

#include <cstdlib>

namespace fulcrum {

namespace fs = std::filesystem;

// XDG Base Directory Specification 0.8: a path that is not absolute is to be ignored.
fs::path config_folder() {
  const char* const xdg = std::getenv("XDG_CONFIG_HOME");
  if (xdg != nullptr && fs::path(xdg).is_absolute()) return fs::path(xdg) / "fulcrum";
  const char* const home = std::getenv("HOME");
  if (home == nullptr || !fs::path(home).is_absolute()) return {};
  return fs::path(home) / ".config" / "fulcrum";
}

}  // namespace fulcrum
