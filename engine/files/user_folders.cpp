#include "engine/files/user_folders.h"

#include <cstdlib>

namespace fulcrum {

namespace {

namespace fs = std::filesystem;

// XDG Base Directory Specification 0.8: a path that is not absolute is to be ignored.
fs::path folder_of(const char* variable, const char* below_home) {
  const char* const xdg = std::getenv(variable);
  if (xdg != nullptr && fs::path(xdg).is_absolute()) return fs::path(xdg) / "fulcrum";
  const char* const home = std::getenv("HOME");
  if (home == nullptr || !fs::path(home).is_absolute()) return {};
  return fs::path(home) / below_home / "fulcrum";
}

}  // namespace

fs::path config_folder() {
  return folder_of("XDG_CONFIG_HOME", ".config");
}

fs::path data_folder() {
  return folder_of("XDG_DATA_HOME", ".local/share");
}

}  // namespace fulcrum
