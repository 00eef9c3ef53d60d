#pragma once
// Where the texts of a scenario come from: files, or the memory of an earlier load. Either way what was read
// is kept.

#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include "haptics/math/result.h"

namespace fulcrum::scenario {

// At most as much as a text may have and one byte more, so that a device or a huge file cannot fill the
// memory.
Result<std::string> read_text_file(const std::filesystem::path& file);

class TextStore {
public:
  TextStore() = default;  // reads files
  explicit TextStore(std::map<std::string, std::string> texts);

  // The text called `name`: from memory, or from the first of `places` that exists.
  Result<std::string> get(const std::string& name, const std::vector<std::filesystem::path>& places);
  // A text that is at hand already.
  void put(const std::string& name, std::string text) { used_[name] = std::move(text); }

  std::map<std::string, std::string> take_used() { return std::move(used_); }

private:
  bool from_memory_ = false;
  std::map<std::string, std::string> texts_;
  std::map<std::string, std::string> used_;
};

}  // namespace fulcrum::scenario
