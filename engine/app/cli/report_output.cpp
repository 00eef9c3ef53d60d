#include "engine/app/cli/report_output.h"

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "engine/app/cli/terminal.h"
#include "engine/files/block_file.h"
#include "engine/files/plain_text.h"
#include "engine/record/run_folder.h"

namespace fulcrum::app {

std::optional<std::filesystem::path> report_folder(std::string_view report, const RunOptions& options,
                                                   std::span<const std::string_view> files) {
  const Result<std::filesystem::path> folder =
      options.out.empty()
          ? record::make_default_run_folder(std::string(report), std::chrono::system_clock::now(), "reports")
          : record::prepare_run_folder(options.out, options.force, files);
  if (!folder) {
    complain(folder.error().sentence);
    return std::nullopt;
  }
  return *folder;
}

bool write_report(const std::filesystem::path& folder,
                  std::initializer_list<std::pair<std::string_view, std::string>> contents) {
  for (const auto& [name, content] : contents) {
    if (const std::optional<Error> error = write_new_file(folder / name, content)) {
      complain(error->sentence);
      return false;
    }
  }
  return true;
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
