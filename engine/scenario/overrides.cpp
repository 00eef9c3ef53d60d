#include "engine/scenario/overrides.h"

#include <algorithm>
#include <charconv>
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "engine/scenario/value_parse.h"
#include "engine/scenario/words.h"
#include "haptics/math/result.h"

namespace fulcrum::scenario {

namespace {

using Parts = std::vector<std::string>;

Parts split(std::string_view path) {
  Parts parts;
  std::size_t from = 0;
  for (std::size_t dot = path.find('.'); dot != path.npos; dot = path.find('.', from)) {
    parts.emplace_back(path.substr(from, dot - from));
    from = dot + 1;
  }
  parts.emplace_back(path.substr(from));
  return parts;
}

bool is_match(std::span<const std::string> pattern, std::span<const std::string> parts) {
  return std::ranges::equal(
      pattern, parts, [](const std::string& p, const std::string& part) { return p == "*" || p == part; });
}

// As a person is told to write it: N for the place of a list's element or the name of an entry.
std::string shown(const KeyEntry& key) {
  std::string path = key.path();
  for (std::size_t at = path.find('*'); at != path.npos; at = path.find('*')) path[at] = 'N';
  return path;
}

Error unknown_key(const std::string& path, std::span<const KeyEntry> keys) {
  std::vector<std::string> paths;  // then, in the same order, their last parts
  for (const KeyEntry& key : keys) paths.push_back(shown(key));
  for (const KeyEntry& key : keys) paths.push_back(key.parts.back());
  if (const auto near = nearest(path, std::span<const std::string>(paths))) {
    const auto index = static_cast<std::size_t>(std::ranges::find(paths, *near) - paths.begin());
    return {"unknown key " + in_quotes(path) + "; did you mean " + in_quotes(paths[index % keys.size()]) +
            "?"};
  }
  return {"unknown key " + in_quotes(path) + "; `fulcrum schema` lists the keys"};
}

// The full path that `path` stands for: itself, or the one key that ends so.
Result<Parts> resolved(const std::string& path, std::span<const KeyEntry> keys) {
  Parts parts = split(path);
  if (std::ranges::any_of(keys, [&](const KeyEntry& key) { return is_match(key.parts, parts); }))
    return parts;
  std::vector<const KeyEntry*> ending;
  for (const KeyEntry& key : keys)
    if (key.parts.size() > parts.size() && is_match(std::span(key.parts).last(parts.size()), parts))
      ending.push_back(&key);
  // "0.radius" must not find checkpoints.*.radius through its wildcard: a part is a key, not an index.
  std::erase_if(ending,
                [&](const KeyEntry* key) { return key->parts[key->parts.size() - parts.size()] == "*"; });
  if (ending.empty()) return unknown_key(path, keys);
  if (ending.size() == 1 && !ending.front()->has_wildcard()) return ending.front()->parts;
  std::string candidates;
  for (const KeyEntry* key : ending) candidates += (candidates.empty() ? "" : ", ") + shown(*key);
  if (ending.size() == 1) {
    return Error{"key " + in_quotes(path) + " is in a list or under a name; write it out as " + candidates +
                 ", with the number, from 0, or the name for N"};
  }
  return Error{"key " + in_quotes(path) + " could be any of " + candidates + "; write it out"};
}

// The place for a value below `node`; absent with a sentence if the file has no such place.
Result<Node*> child(Node& node, const std::string& parent_path, const std::string& part,
                    const std::string& selector, bool is_entry, const Mark& mark) {
  if (node.kind == Node::Kind::list) {
    std::size_t index = 0;
    const char* end = part.data() + part.size();
    const auto [stop, error] = std::from_chars(part.data(), end, index);
    if (error == std::errc() && stop == end && index < node.items.size()) return &node.items[index];
    return Error{in_quotes(parent_path) + " has " + std::to_string(node.items.size()) +
                 " elements, numbered from 0; there is no " + in_quotes(part)};
  }
  if (node.kind == Node::Kind::scalar && !selector.empty()) {  // the short form: a name alone
    Node name = std::exchange(node, Node{Node::Kind::mapping, node.mark, {}, false, {}, {}});
    node.entries.push_back({selector, name.mark, name});
  }
  if (node.kind == Node::Kind::null && !is_entry) {
    node.kind = Node::Kind::mapping;
    node.mark = mark;
  }
  if (NodeEntry* entry = node.find(part)) return &entry->value;
  if (is_entry) {
    std::vector<std::string_view> names;
    for (const NodeEntry& entry : node.entries) names.push_back(entry.key);
    return Error{in_quotes(parent_path) + " has no " + in_quotes(part) +
                 did_you_mean(part, names, names.empty() ? "it is empty" : "it has " + joined(names))};
  }
  if (node.kind != Node::Kind::mapping) {
    return Error{in_quotes(parent_path) + " is " + found(node) +
                 " in the file, not a mapping; repair that first"};
  }
  return &node.entries.emplace_back(NodeEntry{part, mark, {Node::Kind::null, mark, {}, false, {}, {}}}).value;
}

void set_mark(Node& node, const Mark& mark) {
  node.mark = mark;
  for (Node& item : node.items) set_mark(item, mark);
  for (NodeEntry& entry : node.entries) {
    entry.key_mark = mark;
    set_mark(entry.value, mark);
  }
}

std::optional<Fault> apply(Node& root, const std::string& text, std::span<const KeyEntry> keys) {
  const Mark mark{std::make_shared<const std::string>("--set " + on_one_line(text)), 0, 0};
  const std::size_t equals = text.find('=');
  if (equals == text.npos || equals == 0)
    return mark.fault("an override is written KEY=VALUE, for instance contact.stiffness=5000");
  const auto parts = resolved(text.substr(0, equals), keys);
  if (!parts) return mark.fault(parts.error().sentence);

  const std::string value_text = text.substr(equals + 1);
  Node value{Node::Kind::scalar, mark, value_text, false, {}, {}};
  if (!value_text.starts_with('#')) {  // a colour: to YAML it would be a comment
    auto parsed = parse_yaml(value_text, *mark.source);
    if (!parsed) return mark.fault(parsed.faults().front().sentence);
    value = std::move(*parsed);
  }
  set_mark(value, mark);

  Node* node = &root;
  std::string path;
  Parts done;
  for (const std::string& part : *parts) {
    const auto parent = std::ranges::find_if(
        keys, [&](const KeyEntry& key) { return is_match(key.parts, done); });
    const bool is_entry = std::ranges::any_of(keys, [&](const KeyEntry& key) {
      return key.parts.size() > done.size() && key.parts[done.size()] == "*" &&
             is_match(std::span(key.parts).first(done.size()), done);
    });
    const std::string selector = parent == keys.end() ? std::string() : parent->selector;
    const auto next = child(*node, path.empty() ? "the file" : path, part, selector, is_entry, mark);
    if (!next) return mark.fault(next.error().sentence);
    node = *next;
    path += (path.empty() ? "" : ".") + part;
    done.push_back(part);
  }
  *node = std::move(value);
  return std::nullopt;
}

}  // namespace

Faults apply_overrides(Node& root, std::span<const std::string> overrides, std::span<const KeyEntry> keys) {
  Faults faults;
  for (const std::string& text : overrides)
    if (auto fault = apply(root, text, keys)) faults.push_back(std::move(*fault));
  return faults;
}

}  // namespace fulcrum::scenario
