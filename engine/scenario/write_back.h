#pragma once
// Numbers of a scenario's text are changed in it as an author would: comments, order, spaces and all other
// digits stay as they are.

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scenario/fault.h"

namespace fulcrum::scenario {

struct NumberChange {
  std::string path;             // "checkpoints.0.position", "tool.start.orientation", "time_limit"
  std::vector<double> numbers;  // one for a plain number, as many as the list has otherwise
  int decimals = 5;             // written, less the zeros at the end
};

// A key that is not there is added to its mapping, and mappings that are not there with it; what stands in a
// list has to be there. A number that is written as it was before stays as it was written. Faults: the text
// is no YAML; the path leads through something else; the value is no number, or no list of as many.
Checked<std::string> written_back(std::string_view text, std::string_view source,
                                  std::span<const NumberChange> changes);

}  // namespace fulcrum::scenario
