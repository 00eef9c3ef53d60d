#include "engine/scenario/text_store.h"

#include <utility>

#include "engine/scenario/yaml_tree.h"

namespace fulcrum::scenario {

Result<std::string> read_text(const Result<RegularFile>& file) {
  if (!file) return file.error();
  return file->first_bytes(kMaxTextBytes + 1);
}

TextStore::TextStore(std::map<std::string, std::string> texts)
    : from_memory_(true), texts_(std::move(texts)) {}

Result<std::string> TextStore::get(const std::string& name,
                                   const std::function<Result<RegularFile>()>& open) {
  if (from_memory_) {
    const auto text = texts_.find(name);
    if (text == texts_.end()) return Error{"the texts at hand do not include it"};
    used_[name] = text->second;
    return text->second;
  }
  auto text = read_text(open());
  if (text) used_[name] = *text;
  return text;
}

}  // namespace fulcrum::scenario
