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
  const auto too_much = [&] {
    return Error{"the files that the scenario names have more than " + std::to_string(kMaxNamedBytes >> 20) +
                 " MiB of text with it"};
  };
  if (bytes_ > kMaxNamedBytes) return too_much();
  auto text = text_of(name, open);
  if (!text) return text;
  bytes_ += text->size();
  if (bytes_ > kMaxNamedBytes) return too_much();
  used_[name] = *text;
  return text;
}

Result<std::string> TextStore::text_of(const std::string& name,
                                       const std::function<Result<RegularFile>()>& open) const {
  if (!from_memory_) return read_text(open());
  const auto text = texts_.find(name);
  if (text == texts_.end()) return Error{"the texts at hand do not include it"};
  return text->second;
}

}  // namespace fulcrum::scenario
