// Reference: none; any text as that of a scenario, a device, a material or a hand's path, all of which are
// trees first. Invariants: reading it neither crashes nor goes out of bounds; it gives faults that name a
// place in the text, or a tree that is no deeper and no larger than promised.

#include <algorithm>
#include <cstdint>
#include <cstdlib>

#include "engine/scenario/yaml_tree.h"

namespace {

using namespace fulcrum::scenario;

void expect(bool holds) {
  if (!holds) std::abort();
}

// How many nodes there are.
std::size_t count(const Node& node, std::size_t depth, int lines) {
  expect(depth <= kMaxDepth + 1);
  expect(node.mark.line >= 0 && node.mark.line <= lines);
  std::size_t nodes = 1;
  for (const Node& item : node.items) nodes += count(item, depth + 1, lines);
  for (const NodeEntry& entry : node.entries) {
    expect(node.find(entry.key) == &entry);  // once each
    nodes += count(entry.value, depth + 1, lines);
  }
  expect(node.entries.size() <= kMaxKeys);
  return nodes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  const auto ends = [&](char c) { return static_cast<int>(std::ranges::count(text, c)); };
  const int lines = ends('\n') + ends('\r') + 2;
  const auto tree = parse_yaml(text, "text.yaml");
  if (tree) {
    expect(count(*tree, 0, lines) <= kMaxNodes + 1);
    return 0;
  }
  expect(!tree.faults().empty());
  for (const Fault& fault : tree.faults())
    expect(!fault.sentence.empty() && fault.line >= 0 && fault.line <= lines);
  return 0;
}
