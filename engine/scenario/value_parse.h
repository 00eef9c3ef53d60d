#pragma once
// One node -> one value. The sentence, if it is not such a value, goes on from the key's name: "must be ...".

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "engine/scenario/key_visitor.h"
#include "engine/scenario/yaml_tree.h"
#include "haptics/math/result.h"

namespace fulcrum::scenario {

// What is wrong with a value, and where: a list's element has a place of its own.
struct ValueFault {
  Mark mark;
  std::string sentence;              // "must be a number in m; found 'thin'"
  std::vector<ValueFault> others{};  // of a list's further elements
};

template <class T>
class [[nodiscard]] Parsed {
public:
  Parsed(T value) : state_(std::in_place_index<0>, std::move(value)) {}
  Parsed(ValueFault fault) : state_(std::in_place_index<1>, std::move(fault)) {}
  explicit operator bool() const { return state_.index() == 0; }
  const T& operator*() const { return std::get<0>(state_); }
  const ValueFault& fault() const { return std::get<1>(state_); }

private:
  std::variant<T, ValueFault> state_;
};

Parsed<double> parse_real(const Node& node, const Range& range, std::string_view unit);
Parsed<std::int64_t> parse_integer(const Node& node, std::int64_t min, std::int64_t max);
Parsed<bool> parse_boolean(const Node& node);
Parsed<std::string> parse_line(const Node& node);
Parsed<std::string> parse_word(const Node& node);
Parsed<std::size_t> parse_choice(const Node& node, std::span<const std::string_view> names);
Parsed<Vec3> parse_vector(const Node& node, const Range& each, std::string_view unit);
// One to `most` of them.
Parsed<std::vector<double>> parse_numbers(const Node& node, const Range& each, std::string_view unit,
                                          std::size_t most);
Parsed<Vec3> parse_each_axis(const Node& node, const Range& each, std::string_view unit);
Parsed<Quat> parse_rotation(const Node& node);
Parsed<Vec3> parse_colour(const Node& node);  // linear; "#rrggbb" is sRGB

// What a node is, for "found ...".
std::string found(const Node& node);

}  // namespace fulcrum::scenario
