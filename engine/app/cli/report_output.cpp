#include "engine/app/cli/report_output.h"

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cstdio>
#include <utility>
#include <vector>

#include "engine/app/cli/terminal.h"
#include "engine/files/file_error.h"
#include "engine/files/plain_text.h"
#include "engine/files/put_file.h"
#include "engine/record/run_folder.h"

namespace fulcrum::app {

namespace {

constexpr std::string_view kShelf = "reports";

// Nothing: there is none, which is said on stderr.
std::optional<std::filesystem::path> told(const Result<std::filesystem::path>& folder) {
  if (folder) return *folder;
  complain(folder.error().sentence);
  return std::nullopt;
}

}  // namespace

std::optional<ReportPlace> report_place(std::string_view report, const RunOptions& options,
                                        std::span<const std::string_view> files) {
  if (!told(options.out.empty() ? record::default_shelf(kShelf)
                                : record::take_run_folder(options.out, options.force, files)))
    return std::nullopt;
  FolderLock lock;
  if (!options.out.empty()) {
    Result<FolderLock> taken = FolderLock::take(options.out);
    if (!taken) {
      complain(taken.error().sentence);
      return std::nullopt;
    }
    lock = std::move(*taken);
  }
  return ReportPlace{report, options.out, options.force, files, std::move(lock)};
}

std::optional<std::filesystem::path> write_report(
    const ReportPlace& place, std::initializer_list<std::pair<std::string_view, std::string>> contents) {
  // Looked at once more: another program may have written there meanwhile.
  std::optional<std::filesystem::path> folder =
      told(place.out.empty()
               ? record::make_default_run_folder(place.report, std::chrono::system_clock::now(), kShelf)
               : record::take_run_folder(place.out, place.force, place.files));
  if (!folder) return std::nullopt;
  std::vector<std::string_view> old(place.files.begin(), place.files.end());
  for (const auto& [name, content] : contents) {
    if (!put_file(*folder / name, {std::as_bytes(std::span(content))})) {
      complain(file_error("write", *folder / name, errno).sentence);
      return std::nullopt;
    }
    std::erase(old, name);
  }
  if (const Result<std::size_t> removed = record::remove_results(*folder, old); !removed) {
    complain(removed.error().sentence);
    return std::nullopt;
  }
  return folder;
}

// Widths count letters, not bytes.
void print_table(const report::Table& table) {
  const auto letters = [](const std::string& text) {
    return static_cast<std::size_t>(std::count_if(
        text.begin(), text.end(), [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
  };
  std::vector<std::size_t> width;
  for (const std::string& cell : table.head) width.push_back(letters(cell));
  for (const auto& row : table.rows)
    for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], letters(row[i]));
  const auto print = [&](const std::vector<std::string>& row, bool head) {
    std::string line;
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string shown = plain_text(row[i]);  // a name may hold what a terminal would obey
      line += "  " + (head ? bold(shown) : shown) +
              std::string(width[i] - std::min(width[i], letters(shown)), ' ');
    }
    std::printf("%s\n", line.c_str());
  };
  print(table.head, true);
  for (const auto& row : table.rows) print(row, false);
}

}  // namespace fulcrum::app
