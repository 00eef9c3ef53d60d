#include "engine/scenario/value_parse.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <utility>
#include <vector>

#include "engine/scenario/words.h"
#include "haptics/math/functions.h"

namespace fulcrum::scenario {

namespace {

constexpr double kUnitTolerance = 1e-3;  // of a quaternion's length: rounding in a file, not a mistake

bool is_scalar(const Node& node) {
  return node.kind == Node::Kind::scalar;
}

std::string with_unit(double value, std::string_view unit) {
  return unit.empty() ? number_text(value) : number_text(value) + " " + std::string(unit);
}

std::string range_text(const Range& range, std::string_view unit) {
  const bool has_min = std::isfinite(range.min);
  const bool has_max = std::isfinite(range.max);
  std::string text;
  if (has_min) text = (range.above_min ? "above " : "at least ") + with_unit(range.min, has_max ? "" : unit);
  if (has_min && has_max) text += " and ";
  if (has_max) text += "at most " + with_unit(range.max, unit);
  return text;
}

// IEC 61966-2-1: sRGB, 0 to 1, to linear.
double srgb_to_linear(double c) {
  return c <= 0.04045 ? c / 12.92 : math::pow((c + 0.055) / 1.055, 2.4);
}

std::optional<Vec3> parse_hex(std::string_view text) {
  if (text.size() != 7 || text.front() != '#') return std::nullopt;
  Vec3 colour;
  for (int i = 0; i < 3; ++i) {
    const char* begin = text.data() + 1 + 2 * i;
    unsigned value = 0;
    if (std::from_chars(begin, begin + 2, value, 16).ptr != begin + 2) return std::nullopt;
    colour[i] = srgb_to_linear(value / 255.0);
  }
  return colour;
}

// A list of exactly `count` numbers; `what` describes it.
Parsed<std::vector<double>> parse_reals(const Node& node, std::size_t count, const Range& each,
                                        std::string_view unit, const std::string& what) {
  if (node.kind != Node::Kind::list)
    return ValueFault{node.mark, "must be " + what + "; found " + found(node)};
  if (node.items.size() != count) {
    return ValueFault{node.mark,
                      "must be " + what + "; found " + std::to_string(node.items.size()) + " values"};
  }
  std::vector<double> values;
  std::vector<ValueFault> faults;
  for (const Node& item : node.items) {
    const auto value = parse_real(item, each, unit);
    if (value)
      values.push_back(*value);
    else
      faults.push_back({value.fault().mark, "has a component that " + value.fault().sentence});
  }
  if (faults.empty()) return values;
  ValueFault first = std::move(faults.front());
  first.others.assign(std::make_move_iterator(faults.begin() + 1), std::make_move_iterator(faults.end()));
  return first;
}

}  // namespace

std::string found(const Node& node) {
  switch (node.kind) {
    case Node::Kind::null:
      return "nothing";
    case Node::Kind::scalar:
      return node.quoted ? in_quotes(node.text) + " in quotes" : in_quotes(node.text);
    case Node::Kind::list:
      return "a list";
    case Node::Kind::mapping:
      return "a mapping";
  }
  return {};
}

Parsed<double> parse_real(const Node& node, const Range& range, std::string_view unit) {
  const std::string kind = unit.empty() ? "a number" : "a number in " + std::string(unit);
  const auto value = is_scalar(node) && !node.quoted ? parse_number(node.text) : std::nullopt;
  if (!value) {
    const bool has_number =
        is_scalar(node) && !node.text.empty() && node.text.find_first_of("0123456789") == 0;
    return ValueFault{node.mark,
                      "must be " + kind + (has_number ? ", digits alone" : "") + "; found " + found(node)};
  }
  if (!std::isfinite(*value)) return ValueFault{node.mark, "must be a finite number; found " + found(node)};
  if (!range.holds(*value))
    return ValueFault{node.mark, "must be " + range_text(range, unit) + "; found " + found(node)};
  return *value;
}

Parsed<std::int64_t> parse_integer(const Node& node, std::int64_t min, std::int64_t max) {
  const std::string limits = "a whole number from " + std::to_string(min) + " to " + std::to_string(max);
  std::int64_t value = 0;
  const char* end = node.text.data() + node.text.size();
  const bool is_plain = is_scalar(node) && !node.quoted;
  const auto [stop, error] = std::from_chars(node.text.data(), end, value);
  if (!is_plain || error != std::errc() || stop != end || value < min || value > max)
    return ValueFault{node.mark, "must be " + limits + "; found " + found(node)};
  return value;
}

Parsed<bool> parse_boolean(const Node& node) {
  if (is_scalar(node) && !node.quoted) {
    if (node.text == "true") return true;
    if (node.text == "false") return false;
  }
  return ValueFault{node.mark, "must be true or false; found " + found(node)};
}

Parsed<std::string> parse_line(const Node& node) {
  if (!is_scalar(node)) return ValueFault{node.mark, "must be text; found " + found(node)};
  const bool has_control = std::ranges::any_of(node.text, [](char c) {
    const auto code = static_cast<unsigned char>(c);
    return code < 0x20 || code == 0x7f;
  });
  if (has_control)
    return ValueFault{node.mark, "must be one line of text, without tabs; found " + found(node)};
  if (node.text.find_first_not_of(' ') == std::string::npos)
    return ValueFault{node.mark, "must be text; found " + found(node)};
  return node.text;
}

Parsed<std::string> parse_word(const Node& node) {
  if (!is_scalar(node) || !is_word(node.text))
    return ValueFault{node.mark, "must be a name of letters, digits, '_' and '-'; found " + found(node)};
  return node.text;
}

Parsed<std::size_t> parse_choice(const Node& node, std::span<const std::string_view> names) {
  const auto name = is_scalar(node) ? std::ranges::find(names, std::string_view(node.text)) : names.end();
  if (name != names.end()) return static_cast<std::size_t>(name - names.begin());
  std::string sentence =
      (names.size() > 1 ? "must be one of " : "must be ") + joined(names) + "; found " + found(node);
  if (is_scalar(node)) {
    if (const auto near = nearest(node.text, names)) sentence += "; did you mean " + in_quotes(*near) + "?";
  }
  return ValueFault{node.mark, sentence};
}

Parsed<Vec3> parse_vector(const Node& node, const Range& each, std::string_view unit) {
  const std::string what =
      "three numbers [x, y, z]" + (unit.empty() ? std::string() : " in " + std::string(unit));
  const auto values = parse_reals(node, 3, each, unit, what);
  if (!values) return values.fault();
  return Vec3((*values)[0], (*values)[1], (*values)[2]);
}

Parsed<std::vector<double>> parse_numbers(const Node& node, const Range& each, std::string_view unit,
                                          std::size_t most) {
  const std::string what = "a list of 1 to " + std::to_string(most) + " numbers" +
                           (unit.empty() ? std::string() : " in " + std::string(unit));
  const bool counts = !node.items.empty() && node.items.size() <= most;
  return parse_reals(node, counts ? node.items.size() : most, each, unit, what);
}

Parsed<Vec3> parse_each_axis(const Node& node, const Range& each, std::string_view unit) {
  if (!is_scalar(node)) return parse_vector(node, each, unit);
  const auto value = parse_real(node, each, unit);
  if (!value) return value.fault();
  return Vec3(Vec3::Constant(*value));
}

Parsed<Quat> parse_rotation(const Node& node) {
  const auto values = parse_reals(node, 4, kAnyNumber, "", "a unit quaternion [w, x, y, z]");
  if (!values) return values.fault();
  const Quat q((*values)[0], (*values)[1], (*values)[2], (*values)[3]);
  const double length = q.coeffs().stableNorm();
  if (std::abs(length - 1) <= kUnitTolerance) return q.normalized();
  std::string sentence = "must be a unit quaternion [w, x, y, z]; its length is " + number_text(length);
  if (length > 0 && std::isfinite(length)) {
    sentence += "; divided by that it is [" + number_text(q.w() / length) + ", " +
                number_text(q.x() / length) + ", " + number_text(q.y() / length) + ", " +
                number_text(q.z() / length) + "]";
  }
  return ValueFault{node.mark, sentence};
}

Parsed<Vec3> parse_colour(const Node& node) {
  const std::string what = "\"#rrggbb\" (sRGB, in quotes) or three numbers [r, g, b] from 0 to 1 (linear)";
  if (is_scalar(node)) {
    if (const auto colour = parse_hex(node.text)) return *colour;
  }
  const auto values = parse_reals(node, 3, kFraction, "", what);
  if (!values) return values.fault();
  return Vec3((*values)[0], (*values)[1], (*values)[2]);
}

}  // namespace fulcrum::scenario
