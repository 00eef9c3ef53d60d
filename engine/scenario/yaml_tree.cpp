#include "engine/scenario/yaml_tree.h"

#include <yaml-cpp/eventhandler.h>
#include <yaml-cpp/exceptions.h>
#include <yaml-cpp/mark.h>
#include <yaml-cpp/parser.h>

#include <algorithm>
#include <istream>
#include <optional>
#include <streambuf>
#include <utility>

#include "engine/files/utf8.h"
#include "engine/scenario/words.h"
#include "engine/scenario/yaml_slips.h"

namespace fulcrum::scenario {

namespace {

// Ends the parse from inside a handler; never leaves parse_yaml().
struct Refusal {
  Fault fault;
};

class TreeBuilder final : public YAML::EventHandler {
public:
  explicit TreeBuilder(std::shared_ptr<const std::string> source) : source_(std::move(source)) {
    root_.mark = {source_, 1, 1};  // a text without a document has no place of its own
  }

  Mark mark_of(const YAML::Mark& mark) const {
    return {source_, std::max(mark.line, 0) + 1, std::max(mark.column, 0) + 1};
  }

  Node take_root() { return std::move(root_); }

  void OnDocumentStart(const YAML::Mark& mark) override {
    if (documents_++ > 0) {
      refuse(mark,
             "a second document starts here; a file holds one, so remove the '---' and what follows it");
    }
  }
  void OnDocumentEnd() override {}

  void OnAnchor(const YAML::Mark& mark, const std::string& name) override {
    refuse(mark,
           "anchor " + in_quotes("&" + name) + " is not supported; write the value out where it is needed");
  }
  void OnAlias(const YAML::Mark& mark, YAML::anchor_t) override {
    refuse(mark, "an alias (*NAME) is not supported; write the value out where it is needed");
  }

  void OnNull(const YAML::Mark& mark, YAML::anchor_t) override {
    if (wants_key()) refuse(mark, "a key is missing in front of the ':'");
    Node& node = put(Node::Kind::null, mark);
    // The parser notices that a value is missing where the next thing begins: the key is what to point at.
    if (!open_.empty() && open_.back().node->kind == Node::Kind::mapping)
      node.mark = open_.back().node->entries.back().key_mark;
  }

  void OnScalar(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                const std::string& value) override {
    const bool is_quoted = tag == "!";
    if (!is_quoted) refuse_tag(mark, tag);
    if (wants_key()) {
      take_key(mark, value);
      return;
    }
    Node& node = put(Node::Kind::scalar, mark);
    node.text = value;
    node.quoted = is_quoted;
  }

  void OnSequenceStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                       YAML::EmitterStyle::value) override {
    open(Node::Kind::list, mark, tag);
  }
  void OnSequenceEnd() override { open_.pop_back(); }

  void OnMapStart(const YAML::Mark& mark, const std::string& tag, YAML::anchor_t,
                  YAML::EmitterStyle::value) override {
    open(Node::Kind::mapping, mark, tag);
  }
  void OnMapEnd() override { open_.pop_back(); }

private:
  struct Open {
    Node* node;
    bool key_taken = false;  // mapping: the last entry still lacks its value
  };

  [[noreturn]] void refuse(const YAML::Mark& mark, std::string sentence) const {
    throw Refusal{mark_of(mark).fault(std::move(sentence))};
  }

  void refuse_tag(const YAML::Mark& mark, const std::string& tag) const {
    if (tag.empty() || tag == "?") return;
    refuse(mark, "tag " + in_quotes(tag) + " is not supported; types follow from the key, so remove it");
  }

  bool wants_key() const {
    return !open_.empty() && open_.back().node->kind == Node::Kind::mapping && !open_.back().key_taken;
  }

  void take_key(const YAML::Mark& mark, const std::string& key) {
    Open& top = open_.back();
    if (const NodeEntry* first = top.node->find(key)) {
      refuse(mark, "key " + in_quotes(key) + " is already given on line " +
                       std::to_string(first->key_mark.line) + "; remove one of the two");
    }
    if (top.node->entries.size() == kMaxKeys)
      refuse(mark, "a mapping with more than " + std::to_string(kMaxKeys) + " keys; is it the right file?");
    count_node(mark);
    top.node->entries.push_back({key, mark_of(mark), {}});
    top.key_taken = true;
  }

  void count_node(const YAML::Mark& mark) {
    if (++nodes_ > kMaxNodes)
      refuse(mark, "the file has more than " + std::to_string(kMaxNodes) + " values; split it");
  }

  void open(Node::Kind kind, const YAML::Mark& mark, const std::string& tag) {
    refuse_tag(mark, tag == "!" ? "" : tag);
    if (wants_key())
      refuse(
          mark,
          "a list or mapping stands where a key should, which is plain text; is a closing bracket missing?");
    if (open_.size() == kMaxDepth)
      refuse(mark, "lists and mappings are nested deeper than " + std::to_string(kMaxDepth) + " levels");
    open_.push_back({&put(kind, mark)});
  }

  // A parent takes no further child while one of its children is open, so the pointers in open_ stay good.
  Node& put(Node::Kind kind, const YAML::Mark& mark) {
    count_node(mark);
    Node* node = &root_;
    if (!open_.empty()) {
      Open& top = open_.back();
      if (top.node->kind == Node::Kind::list) {
        node = &top.node->items.emplace_back();
      } else {
        node = &top.node->entries.back().value;
        top.key_taken = false;
      }
    }
    node->kind = kind;
    node->mark = mark_of(mark);
    return *node;
  }

  std::shared_ptr<const std::string> source_;
  Node root_;
  std::vector<Open> open_;
  std::size_t nodes_ = 0;
  int documents_ = 0;
};

// A stream over a text, without copying it.
class ViewBuffer final : public std::streambuf {
public:
  explicit ViewBuffer(std::string_view text) {
    char* begin = const_cast<char*>(text.data());  // the interface wants it; the get area is only read
    setg(begin, begin, begin + text.size());
  }
};

}  // namespace

Place Mark::place() const {
  return {source ? *source : std::string(), line, column};
}

NodeEntry* Node::find(std::string_view key) {
  const auto found = std::ranges::find(entries, key, &NodeEntry::key);
  return found == entries.end() ? nullptr : &*found;
}

const NodeEntry* Node::find(std::string_view key) const {
  const auto found = std::ranges::find(entries, key, &NodeEntry::key);
  return found == entries.end() ? nullptr : &*found;
}

Checked<Node> parse_yaml(std::string_view text, std::string_view source) {
  TreeBuilder builder(std::make_shared<const std::string>(source));
  if (text.size() > kMaxTextBytes) {
    return Faults{{std::string(source), 0, 0,
                   "the text is larger than " + std::to_string(kMaxTextBytes >> 20) +
                       " MiB, more than any scenario needs; is it the right file?"}};
  }
  if (const std::size_t good = utf8_bytes(text); good < text.size()) {
    const auto line = 1 + static_cast<int>(std::ranges::count(text.substr(0, good), '\n'));
    return Faults{{std::string(source), line, 1, "this line is not UTF-8: save the file as UTF-8"}};
  }
  ViewBuffer buffer(text);
  std::istream stream(&buffer);
  try {
    YAML::Parser parser(stream);
    while (parser.HandleNextDocument(builder)) {
    }
  } catch (const Refusal& refusal) {
    return Faults{refusal.fault};
  } catch (const YAML::Exception& exception) {
    const Mark mark = builder.mark_of(exception.mark);
    const bool speaks_of_brackets = exception.msg.find("flow") != std::string::npos;
    if (const auto slip = find_slip(text, mark.line, speaks_of_brackets))
      return Faults{{std::string(source), slip->line, slip->column, slip->sentence}};
    // The message may repeat what the text has, a line's end or what a terminal obeys.
    return Faults{mark.fault("this is not valid YAML: " + on_one_line(exception.msg))};
  } catch (const std::exception& exception) {
    return Faults{{std::string(source), 0, 0, std::string("the text cannot be read: ") + exception.what()}};
  }
  return builder.take_root();
}

}  // namespace fulcrum::scenario
