#pragma once
// A report as one HTML page that needs nothing else: no script, no other file, light or dark as its reader
// has it.

#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/report/panels.h"
#include "engine/report/plot.h"

namespace fulcrum::report {

struct Table {
  std::vector<std::string> head;               // a title for each column
  std::vector<std::vector<std::string>> rows;  // as many cells as head; columns but the first are set right
  bool ends_in_words = false;                  // the last column is set left, too, and wraps alone
};

// Names, and what there is to say of each.
using Facts = std::vector<std::pair<std::string, std::string>>;

// A picture of the page's own.
struct NamedPng {
  std::string name, bytes;
};

class Page {
public:
  explicit Page(std::string title) : title_(std::move(title)) {}

  void heading(std::string_view text);
  void paragraph(std::string_view text);
  void note(std::string_view text);     // a paragraph that nobody is to miss
  void command(std::string_view text);  // a line for a terminal
  void facts(const Facts& facts);
  void table(const Table& table);
  void plot(const Plot& plot, std::string_view caption);
  void panels(const Panels& panels, std::string_view caption);
  void pictures(const std::vector<NamedPng>& pictures, std::string_view caption);  // side by side

  std::string html() const;  // well-formed as XML, too

private:
  void figure(std::string_view title, std::string_view drawn, std::string_view caption);

  std::string title_, body_;
};

}  // namespace fulcrum::report
