#pragma once
// What there is instead of a file that is missing or cannot be read, for the end of a sentence.

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::scenario {

// "; did you mean 'expert.yaml'?" if the folder has a file of a name like that; nothing if it has none, or
// `name` itself.
std::string nearby_files(std::string_view name, const std::filesystem::path& folder);

// The same for NAME.yaml in several folders; where there is none like that, "; there is: a, b".
std::string nearby_names(std::string_view name, const std::vector<std::filesystem::path>& folders);

}  // namespace fulcrum::scenario
