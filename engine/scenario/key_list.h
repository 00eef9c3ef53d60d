#pragma once
// Every key that a description has, as dotted paths: what --set can name, and what the schema must list.

#include <string>
#include <string_view>
#include <vector>

#include "engine/scenario/key_visitor.h"

namespace fulcrum::scenario {

struct KeyEntry {
  std::vector<std::string> parts;  // "*": any index of a list, any name of a named mapping
  std::string selector;            // of a key with forms: the key inside that says which
  std::string unit;
  std::string doc;

  std::string path() const;  // contact.stiffness
  bool has_wildcard() const;
};

// In the order of the description; a key that several forms share is there once.
std::vector<KeyEntry> list_keys(const Describe& describe);

}  // namespace fulcrum::scenario
