#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace fulcrum::app {

// "one, another and a third", as in a sentence; of none, an empty text.
inline std::string listed(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size(); ++i)
    text += (i == 0 ? "" : i + 1 == names.size() ? " and " : ", ") + names[i];
  return text;
}

}  // namespace fulcrum::app
