#include "engine/studies/compare_options.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <string_view>

#include "engine/scenario/words.h"

namespace fulcrum::app {

std::string read_variants(const std::string& text, std::vector<TorqueVariant>& variants) {
  constexpr const auto& names = names_of<TorqueVariant>;
  std::vector<TorqueVariant> read;
  std::istringstream in(text);
  for (std::string name; std::getline(in, name, ',');) {
    const auto known = std::find(names.begin(), names.end(), name);
    if (known == names.end())
      return "there is no variant " + scenario::in_quotes(name) +
             scenario::did_you_mean(name, names, "there are A, B and C; give them as A,B,C");
    const auto variant = static_cast<TorqueVariant>(known - names.begin());
    if (std::count(read.begin(), read.end(), variant) > 0) return "variant " + name + " is named twice";
    read.push_back(variant);
  }
  if (read.empty()) return "no variant is named: give some of A,B,C";
  variants = read;
  return {};
}

}  // namespace fulcrum::app
