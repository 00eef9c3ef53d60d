#pragma once
// Where a run's results go, and how those of another run are kept from harm.

#include <chrono>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include "engine/files/folder_lock.h"
#include "haptics/math/result.h"

namespace fulcrum::record {

inline constexpr std::string_view kTraceName = "trace.csv", kTraceJsonName = "trace.json", kTapeName = "tape",
                                  kTimingName = "timing.csv", kFlightName = "flight.csv",
                                  kSummaryName = "summary.json", kPictureName = "frame.png",
                                  kReportName = "report.html", kSoundName = "sound.wav",
                                  kChannelNames = "vibrotactile_motion-*.wav",
                                  kOldChannelNames = "touch-*.wav";  // until trace version 1

// Of the channel of that name.
std::string channel_file_name(std::string_view channel);

// Every file that a run may write into its folder by itself; * stands for any characters.
std::span<const std::string_view> result_file_names();

// Without --out: makes SHELF/SCENARIO-TIME under $XDG_DATA_HOME/fulcrum, or ~/.local/share/fulcrum; TIME is
// UTC. Runs lie in "runs", reports in "reports".
Result<std::filesystem::path> make_default_run_folder(std::string_view scenario,
                                                      std::chrono::system_clock::time_point now,
                                                      std::string_view shelf = "runs");

// Makes that shelf, or takes one that can be written into.
Result<std::filesystem::path> default_shelf(std::string_view shelf);

// With --out: makes the folder, or takes one that has none of these files in it. With force it may have them,
// but for a folder of such a name, and nothing is removed.
Result<std::filesystem::path> take_run_folder(const std::filesystem::path& folder, bool force,
                                              std::span<const std::string_view> files);

// One that a run writes into, and that no other does meanwhile.
struct RunFolder {
  std::filesystem::path path;
  FolderLock lock;
};

// The same, and with force those files that are there are removed, and nothing else. Where another run writes
// into it, nothing is.
Result<RunFolder> prepare_run_folder(const std::filesystem::path& folder, bool force,
                                     std::span<const std::string_view> files = result_file_names());

// Removes those files of a run's folder, the summary last, and nothing else; how many there were.
Result<std::size_t> remove_results(const std::filesystem::path& folder,
                                   std::span<const std::string_view> files = result_file_names());

// How many of them there are.
Result<std::size_t> count_results(const std::filesystem::path& folder);

}  // namespace fulcrum::record
