#pragma once
// Where reports go, and how their tables look in a terminal.

#include <filesystem>
#include <initializer_list>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "engine/app/cli/run_options.h"
#include "engine/files/folder_lock.h"
#include "engine/report/page.h"

namespace fulcrum::app {

// Where a report will be written.
struct ReportPlace {
  std::string_view report;    // its name
  std::filesystem::path out;  // empty: a new folder under the data directory, which is made with the report
  bool force = false;
  std::span<const std::string_view> files;  // what may be written, and is replaced under force alone
  FolderLock lock;                          // of out, for as long as the work takes
};

// Looks at it before the work, and removes nothing. Nothing if it cannot be written, or another program is
// about to write there, which is said on stderr. files: must outlive the place.
std::optional<ReportPlace> report_place(std::string_view report, const RunOptions& options,
                                        std::span<const std::string_view> files);

// The folder that the report lies in now. Each file of an old one stays until the new one is whole, or all
// new ones are there. Nothing: one could not be written, which is said on stderr.
std::optional<std::filesystem::path> write_report(
    const ReportPlace& place, std::initializer_list<std::pair<std::string_view, std::string>> contents);

// On stdout, columns side by side.
void print_table(const report::Table& table);

}  // namespace fulcrum::app
