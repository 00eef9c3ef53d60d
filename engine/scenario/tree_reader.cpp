#include "engine/scenario/tree_reader.h"

#include <algorithm>
#include <system_error>
#include <utility>
#include <vector>

#include "engine/scenario/key_list.h"
#include "engine/scenario/value_parse.h"
#include "engine/scenario/words.h"

namespace fulcrum::scenario {

namespace {

struct Context {
  std::filesystem::path folder;
  Faults faults;
  bool abandoned = false;  // the file's version is another one: nothing else that could be said would help
};

class TreeReader final : public KeyVisitor {
public:
  // `path`: of the mapping, "contact."; empty: the file's own.
  TreeReader(const Node& mapping, std::string path, Context& context)
      : node_(mapping), path_(std::move(path)), context_(context) {}

  void version(const Key& key, std::int64_t version) override;
  void number(const Key& key, double& value, const Range& range) override {
    take(
        key, value, [&](const Node& node) { return parse_real(node, range, key.unit); });
  }
  void optional_number(const Key& key, std::optional<double>& value, const Range& range) override {
    take(
        key, value, [&](const Node& node) { return parse_real(node, range, key.unit); });
  }
  void integer(const Key& key, std::int64_t& value, std::int64_t min, std::int64_t max) override {
    take(
        key, value, [&](const Node& node) { return parse_integer(node, min, max); });
  }
  void boolean(const Key& key, bool& value) override { take(key, value, parse_boolean); }
  void text(const Key& key, std::string& value) override { take(key, value, parse_line); }
  void word(const Key& key, std::string& value) override { take(key, value, parse_word); }
  void choice(const Key& key, std::size_t& index, std::span<const std::string_view> names) override {
    take(
        key, index, [&](const Node& node) { return parse_choice(node, names); });
  }
  void vector(const Key& key, Vec3& value, const Range& each) override {
    take(
        key, value, [&](const Node& node) { return parse_vector(node, each, key.unit); });
  }
  void numbers(const Key& key, std::vector<double>& values, const Range& each, std::size_t most) override {
    take(
        key, values, [&](const Node& node) { return parse_numbers(node, each, key.unit, most); });
  }
  void each_axis(const Key& key, Vec3& value, const Range& each) override {
    take(
        key, value, [&](const Node& node) { return parse_each_axis(node, each, key.unit); });
  }
  void rotation(const Key& key, Quat& value) override { take(key, value, parse_rotation); }
  void colour(const Key& key, Vec3& value) override { take(key, value, parse_colour); }
  void optional_colour(const Key& key, std::optional<Vec3>& value) override {
    take(key, value, parse_colour);
  }
  void file(const Key& key, FileRef& value) override;
  void mapping(const Key& key, const Describe& describe) override;
  void forms(const Key& key, const Key& selector, std::size_t& index, std::span<const Form> forms) override;
  void list(const Key& key, std::size_t min_count, const Describe& describe_next) override;
  void named(const Key& key, std::size_t min_count,
             const std::function<void(std::string_view, KeyVisitor&)>& describe_next) override;

  void rule(std::string_view key, bool holds, std::string_view sentence) override;
  Place where() const override { return node_.mark.place(); }

  using KeyVisitor::colour;
  using KeyVisitor::vector;

  // Once everything has been described: what the mapping has beyond that. `forms`: those the mapping could
  // have had, `chosen` the one it has.
  void finish(std::span<const Form> forms = {}, std::string_view chosen = {});

private:
  std::string full(std::string_view key) const { return in_quotes(path_ + std::string(key)); }
  void fault(const Mark& mark, std::string sentence) {
    context_.faults.push_back(mark.fault(std::move(sentence)));
  }

  // The key's value; null if it is absent, with a fault if that is one.
  const Node* value_of(const Key& key);
  // The same for a mapping: null, with a fault, if it is anything else.
  const Node* mapping_of(const Key& key);

  template <class T, class Parse>
  void take(const Key& key, T& value, const Parse& parse) {
    const Node* node = value_of(key);
    if (!node) return;
    auto parsed = parse(*node);
    if (parsed) {
      value = *parsed;
    } else {
      faulty_.push_back(key.name);
      fault(parsed.fault().mark, full(key.name) + " " + parsed.fault().sentence);
      for (const ValueFault& other : parsed.fault().others)
        fault(other.mark, full(key.name) + " " + other.sentence);
    }
  }

  // Reads a mapping that is, or is part of, the value of `key`.
  void read_inner(const Key& key, const Node& node, const std::string& path, const Describe& describe,
                  std::span<const Form> forms = {}, std::string_view chosen = {});

  const Node& node_;
  std::string path_;
  Context& context_;
  std::vector<std::string_view> known_;   // keys described so far: names of literals
  std::vector<std::string_view> faulty_;  // those of them whose value was refused
};

const Node* TreeReader::value_of(const Key& key) {
  if (context_.abandoned) return nullptr;
  known_.push_back(key.name);
  const NodeEntry* entry = node_.find(key.name);
  if (entry) return &entry->value;
  if (key.required) {
    fault(node_.mark, "key " + full(key.name) + " is missing: " + std::string(key.doc));
    faulty_.push_back(key.name);
  }
  return nullptr;
}

const Node* TreeReader::mapping_of(const Key& key) {
  const Node* node = value_of(key);
  if (!node || node->kind == Node::Kind::mapping) return node;
  fault(node->mark, full(key.name) + " must be a mapping of keys; found " + found(*node));
  return nullptr;
}

void TreeReader::version(const Key& key, std::int64_t version) {
  const std::string line = std::string(key.name) + ": " + std::to_string(version);
  known_.push_back(key.name);
  const NodeEntry* entry = node_.find(key.name);
  if (!entry) {
    fault(node_.mark, "the first line must be " + in_quotes(line) + ", the version of the file's format");
    return;
  }
  if (entry != node_.entries.data()) {
    fault(entry->key_mark,
          full(key.name) + " must be the first key, so that any program can tell the file's format");
  }
  const auto given = parse_integer(entry->value, 1, std::numeric_limits<std::int32_t>::max());
  if (!given) {
    fault(given.fault().mark, full(key.name) + " " + given.fault().sentence);
  } else if (*given != version) {
    fault(entry->value.mark,
          "format " + std::to_string(*given) + " is not known to this program, which reads format " +
              std::to_string(version) + "; take a newer program, or write " + in_quotes(line));
    context_.abandoned = true;
  }
}

void TreeReader::file(const Key& key, FileRef& value) {
  const Node* node = value_of(key);
  if (!node) return;
  const auto refuse = [&](const std::string& sentence) {
    faulty_.push_back(key.name);
    fault(node->mark, full(key.name) + " " + sentence);
  };
  const auto name = parse_line(*node);
  if (!name) return refuse("must name a file; found " + found(*node));
  // Symbolic links and '..' are followed first: what counts is where the file is, not how it is written.
  std::error_code error;
  const auto base = std::filesystem::weakly_canonical(context_.folder, error);
  const auto target =
      error ? std::filesystem::path() : std::filesystem::weakly_canonical(base / *name, error);
  if (error) return refuse("names a file that cannot be looked up: " + error.message());
  const auto outside = std::ranges::mismatch(base, target).in1 != base.end();
  if (outside || target == base) {
    return refuse("must name a file in the scenario's own folder; " + found(*node) +
                  (outside ? " leads out of it; copy the file there" : " is the folder itself"));
  }
  value = {*name, target, node->mark.place()};
}

void TreeReader::read_inner(const Key& key, const Node& node, const std::string& path,
                            const Describe& describe, std::span<const Form> forms, std::string_view chosen) {
  const std::size_t faults_before = context_.faults.size();
  if (node.kind == Node::Kind::mapping) {
    TreeReader inner(node, path + ".", context_);
    describe(inner);
    inner.finish(forms, chosen);
  } else {
    fault(node.mark, in_quotes(path) + " must be a mapping of keys; found " + found(node));
  }
  if (context_.faults.size() > faults_before) faulty_.push_back(key.name);
}

void TreeReader::mapping(const Key& key, const Describe& describe) {
  if (const Node* node = value_of(key)) read_inner(key, *node, path_ + std::string(key.name), describe);
}

void TreeReader::forms(const Key& key, const Key& selector, std::size_t& index, std::span<const Form> forms) {
  const Node* node = value_of(key);
  if (!node) return;
  std::vector<std::string_view> names;
  for (const Form& form : forms) names.push_back(form.name);
  if (node->kind == Node::Kind::scalar) {  // the name alone
    const auto parsed = parse_choice(*node, names);
    if (!parsed) {
      fault(parsed.fault().mark, full(key.name) + " " + parsed.fault().sentence);
      return;
    }
    index = *parsed;
    const Node without_keys{Node::Kind::mapping, node->mark, {}, false, {}, {}};  // some forms need one
    read_inner(key, without_keys, path_ + std::string(key.name), forms[index].describe);
    return;
  }
  const std::string path = path_ + std::string(key.name);
  if (node->kind == Node::Kind::mapping) {
    const NodeEntry* name = node->find(selector.name);
    const auto parsed = name ? parse_choice(name->value, names) : Parsed<std::size_t>(index);
    if (!parsed) {  // which keys belong here depends on the name, so that nothing more can be said
      fault(parsed.fault().mark,
            in_quotes(path + "." + std::string(selector.name)) + " " + parsed.fault().sentence);
      return;
    }
    index = *parsed;
  }
  const Describe with_selector = [&](KeyVisitor& inner) {
    inner.choice(selector, index, names);
    forms[index].describe(inner);
  };
  read_inner(key, *node, path, with_selector, forms, forms[index].name);
}

void TreeReader::list(const Key& key, std::size_t min_count, const Describe& describe_next) {
  const Node* node = value_of(key);
  if (!node) return;
  if (node->kind != Node::Kind::list) {
    fault(node->mark,
          full(key.name) + " must be a list, each element beginning with '- '; found " + found(*node));
    return;
  }
  if (node->items.size() < min_count)
    fault(node->mark, full(key.name) + " must have at least " + std::to_string(min_count) + " element");
  for (std::size_t i = 0; i < node->items.size(); ++i)
    read_inner(key, node->items[i], path_ + std::string(key.name) + "." + std::to_string(i), describe_next);
}

void TreeReader::named(const Key& key, std::size_t min_count,
                       const std::function<void(std::string_view, KeyVisitor&)>& describe_next) {
  const Node* node = mapping_of(key);
  if (!node) return;
  if (node->entries.size() < min_count)
    fault(node->mark, full(key.name) + " must have at least " + std::to_string(min_count) + " entry");
  for (const NodeEntry& entry : node->entries) {
    const std::string path = path_ + std::string(key.name) + "." + entry.key;
    read_inner(key, entry.value, path, [&](KeyVisitor& inner) { describe_next(entry.key, inner); });
  }
}

void TreeReader::rule(std::string_view key, bool holds, std::string_view sentence) {
  if (holds || context_.abandoned || std::ranges::find(faulty_, key) != faulty_.end()) return;
  const NodeEntry* entry = node_.find(key);
  fault(entry ? entry->value.mark : node_.mark, full(key) + " " + std::string(sentence));
}

void TreeReader::finish(std::span<const Form> forms, std::string_view chosen) {
  if (context_.abandoned) return;
  for (const NodeEntry& entry : node_.entries) {
    if (std::ranges::find(known_, entry.key) != known_.end()) continue;
    const auto owner = std::ranges::find_if(forms, [&](const Form& form) {
      const auto keys = list_keys(form.describe);
      return std::ranges::any_of(keys, [&](const KeyEntry& key) { return key.path() == entry.key; });
    });
    if (owner != forms.end()) {
      fault(entry.key_mark, full(entry.key) + " is a key of " + in_quotes(owner->name) + ", not of " +
                                in_quotes(chosen) + ", which takes " + joined(known_));
      continue;
    }
    fault(entry.key_mark, "unknown key " + full(entry.key) +
                              did_you_mean(entry.key, known_, "the keys here are " + joined(known_)));
  }
}

}  // namespace

Faults read_tree(const Node& root, const std::filesystem::path& folder, const Describe& describe) {
  Context context{folder, {}, false};
  if (root.kind != Node::Kind::mapping) {
    return {root.mark.fault("a file must hold a mapping of keys, one 'key: value' to a line; found " +
                            found(root))};
  }
  TreeReader reader(root, "", context);
  describe(reader);
  reader.finish();
  return std::move(context.faults);
}

}  // namespace fulcrum::scenario
