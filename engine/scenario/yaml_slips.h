#pragma once
// Slips of the hand that make a text no YAML, in words that name the slip and not what the parser stumbled
// over.

#include <optional>
#include <string>
#include <string_view>

namespace fulcrum::scenario {

struct YamlSlip {
  int line = 0, column = 0;  // from 1
  std::string sentence;
};

// line: from 1, where the parser gave up. A tab as indent there or on the line before; where the parser
// speaks of brackets, the one that is still open.
std::optional<YamlSlip> find_slip(std::string_view text, int line, bool speaks_of_brackets);

}  // namespace fulcrum::scenario
