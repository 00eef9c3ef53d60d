#include "engine/app/edit/file_watch.h"

#include <sys/stat.h>

#include <algorithm>
#include <array>
#include <string>
#include <string_view>
#include <system_error>

namespace fulcrum::app {
namespace {

namespace fs = std::filesystem;

// Editors keep files of their own beside: those are none of a scenario's.
bool is_of_a_scenario(const fs::path& file) {
  constexpr std::array<std::string_view, 8> kEndings{".yaml", ".yml", ".glb", ".gltf",
                                                     ".bin",  ".png", ".jpg", ".jpeg"};
  std::string ending = file.extension().string();
  std::ranges::transform(ending, ending.begin(),
                         [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
  return std::ranges::find(kEndings, ending) != kEndings.end();
}

}  // namespace

void FileWatch::look_at(const fs::path& file, Files& files) {
  struct stat about {};
  if (::stat(file.c_str(), &about) != 0) return;
  files[file] = {about.st_ino, std::int64_t{about.st_mtim.tv_sec} * 1'000'000'000 + about.st_mtim.tv_nsec,
                 about.st_size};
}

FileWatch::Files FileWatch::look() const {
  Files files;
  std::error_code fault;
  for (const fs::path& folder : {folder_, folder_ / "devices", folder_ / "materials"})
    for (fs::directory_iterator entry(folder, fault), end; !fault && entry != end; entry.increment(fault))
      if (is_of_a_scenario(entry->path())) look_at(entry->path(), files);
  for (const fs::path& file : named_) look_at(file, files);
  return files;
}

void FileWatch::also(const std::vector<fs::path>& files) {
  for (const fs::path& file : files) {
    if (!named_.insert(file).second) continue;
    look_at(file, seen_);
    look_at(file, before_);
  }
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
