#include "engine/record/run_folder.h"

#include <unistd.h>

#include <array>
#include <cerrno>
#include <cstdlib>
#include <ctime>
#include <string>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/files/file_error.h"
#include "engine/files/user_folders.h"

namespace fulcrum::record {

namespace {

namespace fs = std::filesystem;

std::string utc(std::chrono::system_clock::time_point now) {
  const std::time_t seconds = std::chrono::system_clock::to_time_t(now);
  std::tm parts{};
  gmtime_r(&seconds, &parts);
  char text[32];
  return {text, std::strftime(text, sizeof text, "%Y%m%dT%H%M%SZ", &parts)};
}

// A scenario may be named by a path: what cannot be in a file's name becomes a dash.
std::string file_name_of(std::string_view scenario) {
  std::string name(scenario.substr(0, 100));
  for (char& c : name) {
    const bool plain = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '_';
    c = plain ? c : '-';
  }
  return name.empty() ? "run" : name;
}

Result<fs::path> writable(const fs::path& folder) {
  if (::access(folder.c_str(), W_OK | X_OK) != 0) return file_error("write into", folder, errno);
  return folder;
}

// The names of those in the folder that `name` stands for.
std::vector<std::string> present(const fs::path& folder, std::string_view name) {
  const std::size_t star = name.find('*');
  const std::string_view begin = name.substr(0, star);
  const std::string_view end = star == name.npos ? std::string_view() : name.substr(star + 1);
  std::vector<std::string> names;
  std::error_code failure;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, failure)) {
    const std::string file = entry.path().filename().string();
    const bool same = star == name.npos ? file == name
                                        : file.size() >= begin.size() + end.size() &&
                                              file.starts_with(begin) && file.ends_with(end);
    if (same) names.push_back(file);
  }
  return names;
}

}  // namespace

std::string channel_file_name(std::string_view channel) {
  return std::string(kChannelNames).replace(kChannelNames.find('*'), 1, channel);
}

std::span<const std::string_view> result_file_names() {
  static constexpr std::array names = {kTraceName,    kTraceJsonName,   kTapeName,   kTimingName,
                                       kFlightName,   kPictureName,     kReportName, kSoundName,
                                       kChannelNames, kOldChannelNames, kSummaryName};
  return names;
}

Result<fs::path> default_shelf(std::string_view shelf) {
  const fs::path data = data_folder();
  if (data.empty())
    return Error{"Neither XDG_DATA_HOME nor HOME names a folder for the results: name one with --out."};
  const fs::path runs = data / shelf;
  std::error_code failure;
  fs::create_directories(runs, failure);
  if (failure) return file_error("create", runs, failure.value());
  return writable(runs);
}

Result<fs::path> make_default_run_folder(std::string_view scenario, std::chrono::system_clock::time_point now,
                                         std::string_view shelf) {
  const Result<fs::path> runs = default_shelf(shelf);
  if (!runs) return runs.error();
  const std::string name = file_name_of(scenario) + '-' + utc(now);
  fs::path folder = *runs / name;
  std::error_code failure;
  for (int suffix = 2; !fs::create_directory(folder, failure); ++suffix) {
    if (failure) return file_error("create", folder, failure.value());
    folder = *runs / (name + '-' + std::to_string(suffix));
  }
  return writable(folder);
}

Result<fs::path> take_run_folder(const fs::path& folder, bool force,
                                 std::span<const std::string_view> files) {
  std::error_code failure;
  fs::create_directories(folder, failure);
  if (failure) return file_error("create", folder, failure.value());
  for (const std::string_view wanted : files) {
    for (const std::string& name : present(folder, wanted)) {
      if (!force)
        return Error{folder.string() + " holds results (" + name +
                     "): choose another folder with --out, or replace them with --force."};
      if (fs::is_directory(fs::symlink_status(folder / name, failure)))
        return file_error("replace", folder / name, EISDIR);
    }
  }
  return writable(folder);
}

Result<RunFolder> prepare_run_folder(const fs::path& folder, bool force,
                                     std::span<const std::string_view> files) {
  Result<fs::path> taken = take_run_folder(folder, force, files);
  if (!taken) return taken.error();
  Result<FolderLock> lock = FolderLock::take(folder);
  if (!lock) return lock.error();
  // None were there; those that another run has left since stay, and are told of where this one's are made.
  if (!force) return RunFolder{std::move(*taken), std::move(*lock)};
  const Result<std::size_t> removed = remove_results(folder, files);
  if (!removed) return removed.error();
  return RunFolder{std::move(*taken), std::move(*lock)};
}

Result<std::size_t> remove_results(const fs::path& folder, std::span<const std::string_view> files) {
  std::size_t removed = 0;
  for (const std::string_view wanted : files) {
    for (const std::string& name : present(folder, wanted)) {
      // unlink: a link is removed, never what it points to; a folder of that name is not ours and stays.
      const fs::path file = folder / name;
      if (::unlink(file.c_str()) != 0) return file_error("remove", file, errno);
      ++removed;
    }
  }
  return removed;
}

Result<std::size_t> count_results(const fs::path& folder) {
  std::size_t count = 0;
  for (const std::string_view name : result_file_names()) count += present(folder, name).size();
  return count;
}

}  // namespace fulcrum::record
