#include "engine/scenario/text_store.h"

#include <cerrno>
#include <cstring>
#include <fstream>
#include <system_error>

#include "engine/scenario/words.h"
#include "engine/scenario/yaml_tree.h"

namespace fulcrum::scenario {

Result<std::string> read_text_file(const std::filesystem::path& file) {
  std::error_code ignored;
  if (std::filesystem::is_directory(file, ignored)) return Error{"it is a folder, not a file"};
  errno = 0;
  std::ifstream stream(file, std::ios::binary);
  std::string text(kMaxTextBytes + 1, '\0');
  if (stream) stream.read(text.data(), static_cast<std::streamsize>(text.size()));
  if (!stream.is_open() || stream.bad()) {
    return Error{errno != 0 ? std::strerror(errno) : "the file cannot be read"};
  }
  text.resize(static_cast<std::size_t>(stream.gcount()));
  return text;
}

TextStore::TextStore(std::map<std::string, std::string> texts)
    : from_memory_(true), texts_(std::move(texts)) {}

Result<std::string> TextStore::get(const std::string& name,
                                   const std::vector<std::filesystem::path>& places) {
  if (from_memory_) {
    const auto text = texts_.find(name);
    if (text == texts_.end()) return Error{"the texts at hand do not include it"};
    used_[name] = text->second;
    return text->second;
  }
  std::error_code ignored;
  const std::filesystem::path* chosen = &places.front();
  for (auto place = places.rbegin(); place != places.rend(); ++place) {
    if (std::filesystem::exists(*place, ignored)) chosen = &*place;
  }
  auto text = read_text_file(*chosen);
  if (text) used_[name] = *text;
  return text;
}

}  // namespace fulcrum::scenario
