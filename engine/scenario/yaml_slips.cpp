#include "engine/scenario/yaml_slips.h"

#include <algorithm>
#include <vector>

namespace fulcrum::scenario {
namespace {

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return lines;
}

std::optional<YamlSlip> tab_as_indent(const std::vector<std::string_view>& lines, int line) {
  for (const int number : {line, line - 1}) {
    if (number < 1 || static_cast<std::size_t>(number) > lines.size()) continue;
    const std::string_view text = lines[static_cast<std::size_t>(number) - 1];
    const std::size_t tab = text.find('\t');
    if (tab == text.npos || text.find_first_not_of(" \t") < tab) continue;
    return YamlSlip{number, static_cast<int>(tab) + 1,
                    "this line is indented with a tab, which YAML does not allow: use spaces"};
  }
  return std::nullopt;
}

// Brackets outside of quotes and comments, up to the end of the line; whoever writes one in plain text has
// quotes around it.
class OpenBrackets {
public:
  void read(std::string_view line, int number) {
    for (std::size_t i = 0; i < line.size(); ++i) {
      const char c = line[i];
      if (quote_ != 0) {
        if (quote_ == '"' && c == '\\')
          ++i;
        else if (c == quote_)
          quote_ = 0;
        continue;
      }
      if (c == '#' && (i == 0 || line[i - 1] == ' ' || line[i - 1] == '\t')) return;
      const bool begins = i == 0 || std::string_view(" \t[{,:").find(line[i - 1]) != std::string_view::npos;
      if ((c == '"' || c == '\'') && begins) quote_ = c;
      if ((c == '[' || c == '{') && (begins || !open_.empty()))
        open_.push_back({number, static_cast<int>(i) + 1, std::string(1, c)});
      if ((c == ']' || c == '}') && !open_.empty()) open_.pop_back();
    }
  }
  std::optional<YamlSlip> last() const {
    if (open_.empty()) return std::nullopt;
    const bool list = open_.back().sentence == "[";
    return YamlSlip{open_.back().line, open_.back().column,
                    list ? "this '[' is not closed: write ']' where the list ends"
                         : "this '{' is not closed: write '}' where the mapping ends"};
  }

private:
  std::vector<YamlSlip> open_;  // their sentence: the bracket
  char quote_ = 0;
};

}  // namespace

std::optional<YamlSlip> find_slip(std::string_view text, int line, bool speaks_of_brackets) {
  const std::vector<std::string_view> lines = lines_of(text);
  if (auto tab = tab_as_indent(lines, line)) return tab;
  if (!speaks_of_brackets) return std::nullopt;
  OpenBrackets brackets;
  for (std::size_t i = 0; i < lines.size() && static_cast<int>(i) < line; ++i)
    brackets.read(lines[i], static_cast<int>(i) + 1);
  return brackets.last();
}

}  // namespace fulcrum::scenario
