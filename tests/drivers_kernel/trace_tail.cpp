#include "tests/drivers_kernel/trace_tail.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <iterator>
#include <sstream>

namespace fulcrum::test {
namespace {

constexpr std::array<const char*, 9> kColumns{"timestamp",  "handle/p/x", "handle/p/y",
                                              "handle/p/z", "handle/q/w", "handle/q/x",
                                              "handle/q/y", "handle/q/z", "task/step"};

std::vector<std::string> cells_of(const std::string& line) {
  std::vector<std::string> cells;
  std::istringstream text(line);
  for (std::string cell; std::getline(text, cell, ',');) cells.push_back(cell);
  return cells;
}

}  // namespace

std::optional<TraceRow> TraceTail::newest() {
  if (!file_.is_open()) file_.open(path_);
  file_.clear();  // it may have been at the end
  rest_.append(std::istreambuf_iterator<char>(file_), {});
  if (columns_.empty()) {
    const std::size_t end = rest_.find('\n');
    if (end == std::string::npos) return std::nullopt;
    const std::vector<std::string> names = cells_of(rest_.substr(0, end));
    for (const char* column : kColumns)
      columns_.push_back(static_cast<std::size_t>(std::ranges::find(names, column) - names.begin()));
    rest_.erase(0, end + 1);
  }
  const std::size_t end = rest_.rfind('\n');
  if (end == std::string::npos) return std::nullopt;
  const std::size_t before = end == 0 ? std::string::npos : rest_.rfind('\n', end - 1);
  const std::size_t start = before == std::string::npos ? 0 : before + 1;
  const std::vector<std::string> cells = cells_of(rest_.substr(start, end - start));
  rest_.erase(0, end + 1);
  std::array<double, kColumns.size()> values{};
  for (std::size_t i = 0; i < values.size(); ++i)
    values[i] = std::strtod(cells.at(columns_[i]).c_str(), nullptr);
  TraceRow row{.time = values[0], .X_WH = {}, .task_step = static_cast<int>(values[8])};
  row.X_WH.p = {values[1], values[2], values[3]};
  row.X_WH.q = Quat(values[4], values[5], values[6], values[7]);
  return row;
}

}  // namespace fulcrum::test
