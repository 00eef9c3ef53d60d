#pragma once
// A table as CSV (RFC 4180, lines end in \n): one header line, numbers that read back to the same bits.

#include <initializer_list>
#include <span>
#include <string>
#include <string_view>
#include <variant>

namespace fulcrum::report {

class Csv {
public:
  explicit Csv(std::span<const std::string_view> columns);
  explicit Csv(std::initializer_list<std::string_view> columns)
      : Csv(std::span(columns.begin(), columns.size())) {}

  using Cell = std::variant<std::string_view, double>;
  void row(std::span<const Cell> cells);  // as many as columns
  void row(std::initializer_list<Cell> cells) { row(std::span(cells.begin(), cells.size())); }

  const std::string& text() const { return text_; }

private:
  std::size_t columns_;
  std::string text_;
};

}  // namespace fulcrum::report
