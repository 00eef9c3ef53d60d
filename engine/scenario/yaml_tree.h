#pragma once
// YAML text -> a tree of nodes that know where they stand.
//
// The subset is what a person writes by hand: one document of mappings, lists and scalars. Refused, with line
// and column: a key twice in one mapping, anchors and aliases, tags, more than one document, keys that are
// not plain text, and what is larger or deeper than anything a person writes (a hostile file must not cost
// memory or stack).

#include <cstddef>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scenario/fault.h"

namespace fulcrum::scenario {

inline constexpr std::size_t kMaxTextBytes = std::size_t{1} << 20;
inline constexpr std::size_t kMaxNodes = 100'000;
inline constexpr std::size_t kMaxKeys = 1000;  // of one mapping
inline constexpr std::size_t kMaxDepth = 24;

struct Mark {
  std::shared_ptr<const std::string> source;  // a file, or "--set KEY=VALUE"
  int line = 0;                               // from 1; 0: the whole source
  int column = 0;                             // from 1

  Place place() const;
  Fault fault(std::string sentence) const { return place().fault(std::move(sentence)); }
};

struct NodeEntry;

struct Node {
  enum class Kind { null, scalar, list, mapping };
  Kind kind = Kind::null;
  Mark mark;
  std::string text;                // scalar
  bool quoted = false;             // scalar: it stood in quotes, or as a block of text
  std::vector<Node> items;         // list
  std::vector<NodeEntry> entries;  // mapping, in the order of the file

  NodeEntry* find(std::string_view key);
  const NodeEntry* find(std::string_view key) const;
};

struct NodeEntry {
  std::string key;
  Mark key_mark;
  Node value;
};

// `source` stands in faults for the text.
Checked<Node> parse_yaml(std::string_view text, std::string_view source);

}  // namespace fulcrum::scenario
