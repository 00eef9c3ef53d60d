#pragma once
// Where the texts of a scenario come from: files, or the memory of an earlier load. Either way what was read
// is kept.

#include <functional>
#include <map>
#include <string>

#include "engine/files/regular_file.h"
#include "haptics/math/result.h"

namespace fulcrum::scenario {

// Of all files that a scenario names together, one that is named twice counted twice: each hand reads its
// path.
inline constexpr std::size_t kMaxNamedBytes = std::size_t{4} << 20;

// At most as much as a text may have and one byte more, so that a huge file cannot fill the memory.
Result<std::string> read_text(const Result<RegularFile>& file);

class TextStore {
public:
  TextStore() = default;  // reads files
  explicit TextStore(std::map<std::string, std::string> texts);

  bool reads_files() const { return !from_memory_; }
  bool has(const std::string& name) const { return texts_.contains(name); }  // in the memory

  // The text called `name`: from memory, or from the file that is opened. A sentence where that would be more
  // than kMaxNamedBytes.
  Result<std::string> get(const std::string& name, const std::function<Result<RegularFile>()>& open);
  // A text that is at hand already.
  void put(const std::string& name, std::string text) { used_[name] = std::move(text); }

  std::map<std::string, std::string> take_used() { return std::move(used_); }

private:
  Result<std::string> text_of(const std::string& name,
                              const std::function<Result<RegularFile>()>& open) const;

  bool from_memory_ = false;
  std::map<std::string, std::string> texts_;
  std::map<std::string, std::string> used_;
  std::size_t bytes_ = 0;  // that get() gave
};

}  // namespace fulcrum::scenario
