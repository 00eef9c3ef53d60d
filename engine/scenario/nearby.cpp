#include "engine/scenario/nearby.h"

#include <algorithm>
#include <set>
#include <system_error>

#include "engine/scenario/words.h"

namespace fulcrum::scenario {

namespace {

template <class Use>
void for_each_file(const std::filesystem::path& folder, const Use& use) {
  std::error_code error;
  std::filesystem::directory_iterator entry(folder, error);
  while (!error && entry != std::filesystem::directory_iterator()) {
    use(entry->path());
    entry.increment(error);
  }
}

}  // namespace

std::string nearby_files(std::string_view name, const std::filesystem::path& folder) {
  std::set<std::string> names;  // sorted: a folder's own order is chance
  for_each_file(folder, [&](const std::filesystem::path& file) { names.insert(file.filename().string()); });
  if (names.contains(std::string(name))) return {};  // it is there, and no file that can be read
  const std::vector<std::string> list(names.begin(), names.end());
  const auto near = nearest(name, std::span<const std::string>(list));
  return near ? "; did you mean " + in_quotes(*near) + "?" : std::string();
}

std::string nearby_names(std::string_view name, const std::vector<std::filesystem::path>& folders) {
  std::set<std::string> names;
  for (const auto& folder : folders) {
    for_each_file(
        folder,
        [&](const std::filesystem::path& file) {
          if (file.extension() == ".yaml") names.insert(file.stem().string());
        });
  }
  if (names.contains(std::string(name))) return {};
  const std::vector<std::string_view> list(names.begin(), names.end());
  return did_you_mean(name, list, names.empty() ? "there is none" : "there is: " + joined(list));
}

}  // namespace fulcrum::scenario
