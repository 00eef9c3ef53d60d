#pragma once
// The words of fault sentences: quoting what a person wrote, numbers, and the nearest of the names that
// exist.

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace fulcrum::scenario {

// Control characters become spaces: a sentence from a file is one line, and nothing that a terminal obeys.
std::string on_one_line(std::string text);

// 'text' for a sentence: one line, no control characters, shortened if it is long.
std::string in_quotes(std::string_view text);

// Letters, digits, '_' and '-': what can be part of a file's name and of a column's.
bool is_word(std::string_view text);

// A number as it would be written in a file: the shortest text that reads back as the same number.
std::string number_text(double value);

// Text -> a number as YAML writes them (12, -0.5, 1e-3, .5). Absent: not such a number. Infinite: too large
// for one, or .inf; not a number: .nan.
std::optional<double> parse_number(std::string_view text);

// The double that reads as the float does: 0.96F gives 0.96.
double widened(float value);

// Insertions, deletions, replacements and swaps of neighbours that make b of a.
std::size_t edit_distance(std::string_view a, std::string_view b);

// The candidate that a slip of the hand would have made `word` of, or `word` with a unit behind it; absent if
// none is near. An equal distance: the first.
std::optional<std::string_view> nearest(std::string_view word, std::span<const std::string_view> candidates);
std::optional<std::string_view> nearest(std::string_view word, std::span<const std::string> candidates);

// "; did you mean 'stiffness'?" or, without a near one, the remedy given.
std::string did_you_mean(std::string_view word, std::span<const std::string_view> candidates,
                         std::string_view otherwise);

std::string joined(std::span<const std::string_view> words, std::string_view separator = ", ");

}  // namespace fulcrum::scenario
