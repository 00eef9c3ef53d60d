#pragma once
// How a file's keys are described, once. A description is a function that shows every key to a KeyVisitor
// together with the variable it belongs to; the variable's value before the visit is the default. The
// visitors are the reader (tree_reader.h), the list of keys for --set (key_list.h) and the writer of the
// schema (schema_writer.h), so that a key cannot be read and yet be missing from the other two.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scenario/fault.h"
#include "engine/scenario/scenario.h"
#include "haptics/math/names_of.h"

namespace fulcrum::scenario {

struct Key {
  std::string_view name;
  std::string_view unit;  // empty: none, or said by the name
  std::string_view doc;   // one line
  bool required = false;
};

// What a number may be. Not finite is refused in any case.
struct Range {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
  bool above_min = false;  // min itself is not in the range

  bool holds(double value) const { return (above_min ? value > min : value >= min) && value <= max; }
};

inline constexpr Range kAnyNumber{};
inline constexpr Range kFraction{0, 1, false};
inline constexpr Range at_least(double min) {
  return {min, kAnyNumber.max, false};
}
inline constexpr Range from_to(double min, double max) {
  return {min, max, false};
}
inline constexpr Range above_to(double min, double max) {
  return {min, max, true};
}

// m: scenes are rooms, not landscapes; what is farther away is a slip of the unit.
inline constexpr Range kPosition{-1000, 1000, false};

class KeyVisitor;
using Describe = std::function<void(KeyVisitor&)>;

// One form of a mapping whose other keys depend on the value of one of them.
struct Form {
  std::string_view name;
  std::string_view doc;
  Describe describe;
};

class KeyVisitor {
public:
  virtual ~KeyVisitor() = default;

  virtual void version(const Key& key, std::int64_t version) = 0;  // must be the first key of the file
  virtual void number(const Key& key, double& value, const Range& range) = 0;
  virtual void optional_number(const Key& key, std::optional<double>& value, const Range& range) = 0;
  virtual void integer(const Key& key, std::int64_t& value, std::int64_t min, std::int64_t max) = 0;
  virtual void boolean(const Key& key, bool& value) = 0;
  virtual void text(const Key& key, std::string& value) = 0;  // one line, not empty
  virtual void word(const Key& key, std::string& value) = 0;  // letters, digits, '_' and '-'
  // index: names.size() where none is chosen; then the key may be left out.
  virtual void choice(const Key& key, std::size_t& index, std::span<const std::string_view> names) = 0;
  virtual void vector(const Key& key, Vec3& value, const Range& each) = 0;
  // Up to `most` numbers; none: the key may be left out.
  virtual void numbers(const Key& key, std::vector<double>& values, const Range& each, std::size_t most) = 0;
  virtual void each_axis(const Key& key, Vec3& value, const Range& each) = 0;  // three, or one for all
  virtual void rotation(const Key& key, Quat& value) = 0;
  virtual void colour(const Key& key, Vec3& value) = 0;  // linear
  virtual void optional_colour(const Key& key, std::optional<Vec3>& value) = 0;
  virtual void file(const Key& key, FileRef& value) = 0;
  virtual void mapping(const Key& key, const Describe& describe) = 0;
  // A mapping whose key `selector` names one of `forms`; written as that name alone, it is the form's
  // defaults.
  virtual void forms(const Key& key, const Key& selector, std::size_t& index,
                     std::span<const Form> forms) = 0;
  // A list of mappings. describe_next appends an element to its variable and describes it.
  virtual void list(const Key& key, std::size_t min_count, const Describe& describe_next) = 0;
  // A mapping from names the author chooses to mappings. describe_next appends an element of that name.
  virtual void named(const Key& key, std::size_t min_count,
                     const std::function<void(std::string_view name, KeyVisitor&)>& describe_next) = 0;

  // A rule about what has been described so far at this level; `key` is where a fault points. Only a reader
  // looks.
  virtual void rule(std::string_view, bool, std::string_view) {}
  // Where the mapping that is being described stands; empty but for a reader.
  virtual Place where() const { return {}; }

  void real(const Key& key, float& value, const Range& range);
  void vector(const Key& key, glm::vec3& value, const Range& each);
  void colour(const Key& key, glm::vec3& value);
  template <class Enum>
  void choice_of(const Key& key, Enum& value) {
    auto index = static_cast<std::size_t>(value);
    choice(key, index, names_of<Enum>);
    value = static_cast<Enum>(index);
  }
  template <class Enum>
  void choice_of(const Key& key, std::optional<Enum>& value) {
    constexpr std::span<const std::string_view> names(names_of<Enum>);
    std::size_t index = value ? static_cast<std::size_t>(*value) : names.size();
    choice(key, index, names);
    if (index < names.size()) value = static_cast<Enum>(index);
  }
};

// A pose: `position` and `orientation`.
void describe_pose(KeyVisitor& visitor, Pose& pose, std::string_view position_doc,
                   std::string_view orientation_doc);

}  // namespace fulcrum::scenario
