#include "engine/app/edit/file_watch.h"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <string_view>
#include <system_error>

namespace fulcrum::app {
namespace {

namespace fs = std::filesystem;

// Editors keep files of their own beside: those are none of a scenario's.
bool is_of_a_scenario(const fs::path& file) {
  constexpr std::array<std::string_view, 4> kEndings{".yaml", ".glb", ".gltf", ".bin"};
  return std::ranges::find(kEndings, file.extension().string()) != kEndings.end();
}

}  // namespace

FileWatch::Files FileWatch::look() const {
  Files files;
  std::error_code fault;
  for (const fs::path& folder : {folder_, folder_ / "devices", folder_ / "materials"}) {
    for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end; entry.increment(fault)) {
      if (!is_of_a_scenario(entry->path())) continue;
      struct stat about {};
      if (::stat(entry->path().c_str(), &about) != 0) continue;
      files[entry->path()] = {about.st_ino,
                              std::int64_t{about.st_mtim.tv_sec} * 1'000'000'000 + about.st_mtim.tv_nsec,
                              about.st_size};
    }
  }
  return files;
}

bool FileWatch::saved() {
  Files now = look();
  const bool at_rest = now == before_;
  before_ = std::move(now);
  if (!at_rest || before_ == seen_) return false;
  seen_ = before_;
  return true;
}

}  // namespace fulcrum::app
