#include "engine/scenario/write_back.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <optional>
#include <utility>

#include "engine/scenario/value_parse.h"
#include "engine/scenario/words.h"
#include "engine/scenario/yaml_tree.h"

namespace fulcrum::scenario {
namespace {

std::string number_of(double value, int decimals) {
  char digits[400];
  std::snprintf(digits, sizeof digits, "%.*f", decimals, value);
  std::string text = digits;
  if (decimals > 0) text.erase(text.find_last_not_of('0') + 1);
  if (text.back() == '.') text.pop_back();
  return text == "-0" ? "0" : text;
}

std::string value_of(const NumberChange& change) {
  if (change.numbers.size() == 1) return number_of(change.numbers.front(), change.decimals);
  std::string text = "[";
  for (const double number : change.numbers)
    text += (text.size() > 1 ? ", " : "") + number_of(number, change.decimals);
  return text + "]";
}

// Where a mark stands, in bytes.
std::size_t offset_of(std::string_view text, const Mark& mark) {
  std::size_t at = 0;
  for (int line = 1; line < mark.line; ++line) {
    at = text.find('\n', at);
    if (at == text.npos) return text.size();
    ++at;
  }
  return std::min(text.size(), at + static_cast<std::size_t>(mark.column - 1));
}

// Of a plain number: up to what cannot be part of one.
std::size_t end_of_number(std::string_view text, std::size_t begin) {
  return std::min(text.size(), text.find_first_of(" \t\r\n,]}#", begin));
}

std::optional<double> number_in(const Node& node) {
  if (node.kind != Node::Kind::scalar || node.quoted) return std::nullopt;
  const auto parsed = parse_real(node, kAnyNumber, {});
  return parsed ? std::optional(*parsed) : std::nullopt;
}

class Editor {
public:
  Editor(std::string text, std::string_view source) : text_(std::move(text)), source_(source) {}

  // Empty: it is done.
  Faults change(const NumberChange& change) {
    const auto root = parse_yaml(text_, source_);
    if (!root) return root.faults();
    const Node* node = &*root;
    std::string_view rest = change.path;
    while (!rest.empty()) {
      const std::string_view part = rest.substr(0, rest.find('.'));
      const Node* inner = child(*node, part);
      if (inner == nullptr) break;
      node = inner;
      rest.remove_prefix(std::min(part.size() + 1, rest.size()));
    }
    return rest.empty() ? replace(*node, change) : add(*node, rest, node == &*root, change);
  }

  std::string take() { return std::move(text_); }

private:
  static const Node* child(const Node& node, std::string_view part) {
    if (const NodeEntry* entry = node.find(part)) return &entry->value;
    std::size_t index = 0;
    const char* const end = part.data() + part.size();
    if (std::from_chars(part.data(), end, index).ptr != end || index >= node.items.size()) return nullptr;
    return &node.items[index];
  }

  // From the last to the first, so that the marks before stay good.
  Faults replace(const Node& node, const NumberChange& change) {
    std::vector<const Node*> nodes;
    if (node.kind == Node::Kind::list)
      for (const Node& item : node.items) nodes.push_back(&item);
    else
      nodes.push_back(&node);
    if (nodes.size() != change.numbers.size()) return {refused(node, change)};
    for (std::size_t i = nodes.size(); i-- > 0;) {
      const std::optional<double> old = number_in(*nodes[i]);
      if (!old) return {refused(*nodes[i], change)};
      const std::string written = number_of(change.numbers[i], change.decimals);
      if (number_of(*old, change.decimals) == written) continue;
      const std::size_t begin = offset_of(text_, nodes[i]->mark), end = end_of_number(text_, begin);
      // The place of a mark is the parser's word; what stands there has to be this number.
      if (text_.substr(begin, end - begin) != nodes[i]->text) return {refused(*nodes[i], change)};
      text_.replace(begin, end - begin, written);
    }
    return {};
  }

  // `rest` of the path is not there; it goes into the mapping.
  Faults add(const Node& node, std::string_view rest, bool is_root, const NumberChange& change) {
    if (node.kind != Node::Kind::mapping || node.entries.empty()) return {refused(node, change)};
    std::string value = value_of(change);
    for (std::size_t dot = rest.rfind('.'); dot != rest.npos; dot = rest.rfind('.')) {
      std::string inner = "{";
      inner.append(rest.substr(dot + 1)).append(": ").append(value).append("}");
      value = std::move(inner);
      rest = rest.substr(0, dot);
    }
    std::string entry(rest);
    entry.append(": ").append(value);
    const std::size_t begin = offset_of(text_, node.mark);
    const NodeEntry& first = node.entries.front();
    if (begin < text_.size() && text_[begin] == '{') {
      const bool alone = node.entries.size() == 1;
      text_.insert(offset_of(text_, alone ? first.key_mark : node.entries[1].key_mark), entry + ", ");
    } else if (is_root) {
      // The first key of a file is its version.
      if (!text_.ends_with('\n')) text_ += '\n';
      text_ += entry + '\n';
    } else {
      // Before the first entry, which moves into a line of its own: that may be the line of a list's dash.
      const std::string indent(static_cast<std::size_t>(first.key_mark.column - 1), ' ');
      text_.insert(offset_of(text_, first.key_mark), entry + '\n' + indent);
    }
    return {};
  }

  static Fault refused(const Node& node, const NumberChange& change) {
    return node.mark.fault(in_quotes(change.path) + " cannot be written here; change it by hand to " +
                           value_of(change));
  }

  std::string text_;
  std::string_view source_;
};

}  // namespace

Checked<std::string> written_back(std::string_view text, std::string_view source,
                                  std::span<const NumberChange> changes) {
  Editor editor{std::string(text), source};
  for (const NumberChange& change : changes)
    if (Faults faults = editor.change(change); !faults.empty()) return faults;
  std::string written = editor.take();
  if (parse_yaml(written, source)) return written;
  return Faults{{std::string(source), 0, 0,
                 "cannot be written in this text; change it by hand: " + changes.front().path + " to " +
                     value_of(changes.front())}};
}

}  // namespace fulcrum::scenario
