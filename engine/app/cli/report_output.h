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
#include "engine/report/page.h"

namespace fulcrum::app {

// options.out, or a new folder under the data directory; nothing if that cannot be, which is said on stderr.
// files: what the report will write, and replaces under options.force alone.
std::optional<std::filesystem::path> report_folder(std::string_view report, const RunOptions& options,
                                                   std::span<const std::string_view> files);

// False: a file could not be written, which is said on stderr.
bool write_report(const std::filesystem::path& folder,
                  std::initializer_list<std::pair<std::string_view, std::string>> contents);

// On stdout, columns side by side.
void print_table(const report::Table& table);

}  // namespace fulcrum::app
