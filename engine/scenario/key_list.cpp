#include "engine/scenario/key_list.h"

#include <algorithm>
#include <utility>

namespace fulcrum::scenario {

namespace {

class KeyLister final : public KeyVisitor {
public:
  void version(const Key& key, std::int64_t) override { add(key); }
  void number(const Key& key, double&, const Range&) override { add(key); }
  void optional_number(const Key& key, std::optional<double>&, const Range&) override { add(key); }
  void integer(const Key& key, std::int64_t&, std::int64_t, std::int64_t) override { add(key); }
  void boolean(const Key& key, bool&) override { add(key); }
  void text(const Key& key, std::string&) override { add(key); }
  void word(const Key& key, std::string&) override { add(key); }
  void choice(const Key& key, std::size_t&, std::span<const std::string_view>) override { add(key); }
  void vector(const Key& key, Vec3&, const Range&) override { add(key); }
  void numbers(const Key& key, std::vector<double>&, const Range&, std::size_t) override { add(key); }
  void each_axis(const Key& key, Vec3&, const Range&) override { add(key); }
  void rotation(const Key& key, Quat&) override { add(key); }
  void colour(const Key& key, Vec3&) override { add(key); }
  void optional_colour(const Key& key, std::optional<Vec3>&) override { add(key); }
  void file(const Key& key, FileRef&) override { add(key); }

  void mapping(const Key& key, const Describe& describe) override {
    add(key);
    within({std::string(key.name)}, describe);
  }
  void forms(const Key& key, const Key& selector, std::size_t&, std::span<const Form> forms) override {
    add(key);
    entries_.back().selector = selector.name;
    within({std::string(key.name)}, [&](KeyVisitor&) { add(selector); });
    for (const Form& form : forms) within({std::string(key.name)}, form.describe);
  }
  void list(const Key& key, std::size_t, const Describe& describe_next) override {
    add(key);
    within({std::string(key.name), "*"}, describe_next);
  }
  void named(const Key& key, std::size_t,
             const std::function<void(std::string_view, KeyVisitor&)>& describe_next) override {
    add(key);
    within({std::string(key.name), "*"}, [&](KeyVisitor& inner) { describe_next("*", inner); });
  }

  using KeyVisitor::colour;
  using KeyVisitor::vector;

  std::vector<KeyEntry> take() { return std::move(entries_); }

private:
  void add(const Key& key) {
    KeyEntry entry{parts_, {}, std::string(key.unit), std::string(key.doc)};
    entry.parts.emplace_back(key.name);
    const bool known = std::ranges::find(entries_, entry.parts, &KeyEntry::parts) != entries_.end();
    if (!known) entries_.push_back(std::move(entry));
  }

  void within(const std::vector<std::string>& parts, const Describe& describe) {
    parts_.insert(parts_.end(), parts.begin(), parts.end());
    describe(*this);
    parts_.resize(parts_.size() - parts.size());
  }

  std::vector<std::string> parts_;
  std::vector<KeyEntry> entries_;
};

}  // namespace

std::string KeyEntry::path() const {
  std::string text;
  for (const std::string& part : parts) {
    if (!text.empty()) text += '.';
    text += part;
  }
  return text;
}

bool KeyEntry::has_wildcard() const {
  return std::ranges::find(parts, "*") != parts.end();
}

std::vector<KeyEntry> list_keys(const Describe& describe) {
  KeyLister lister;
  describe(lister);
  return lister.take();
}

}  // namespace fulcrum::scenario
