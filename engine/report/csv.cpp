#include "engine/report/csv.h"

#include <cassert>

#include "engine/files/number_text.h"

namespace fulcrum::report {
namespace {

void append_text(std::string& to, std::string_view cell) {
  if (cell.find_first_of(",\"\r\n") == cell.npos) {
    to += cell;
    return;
  }
  to += '"';
  for (const char c : cell) to.append(c == '"' ? 2 : 1, c);
  to += '"';
}

}  // namespace

Csv::Csv(std::span<const std::string_view> columns) : columns_(columns.size()) {
  for (const std::string_view column : columns) {
    if (!text_.empty()) text_ += ',';
    append_text(text_, column);
  }
  text_ += '\n';
}

void Csv::row(std::span<const Cell> cells) {
  assert(cells.size() == columns_);
  bool first = true;
  for (const Cell& cell : cells) {
    if (!first) text_ += ',';
    first = false;
    if (const double* number = std::get_if<double>(&cell))
      append_number(text_, *number);
    else
      append_text(text_, std::get<std::string_view>(cell));
  }
  text_ += '\n';
}

}  // namespace fulcrum::report
