#include "engine/scenario/hint.h"

#include <algorithm>
#include <span>

#include "engine/scenario/words.h"

namespace fulcrum::scenario {
namespace {

constexpr std::span<const std::string_view> kWords(names_of<HintWord>);

// Of UTF-8: bytes that do not go on with one.
std::size_t letters(std::string_view text) {
  return static_cast<std::size_t>(std::ranges::count_if(
      text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0U) != 0x80U; }));
}

// Calls plain(text) and word(name) for what the hint is made of, in order; false: a brace has no other.
template <class Plain, class Word>
bool take_apart(std::string_view hint, const Plain& plain, const Word& word) {
  while (!hint.empty()) {
    const std::size_t open = hint.find_first_of("{}");
    plain(hint.substr(0, open));
    if (open == hint.npos) return true;
    const std::size_t close = hint.find_first_of("{}", open + 1);
    if (hint[open] == '}' || close == hint.npos || hint[close] == '{') return false;
    word(hint.substr(open + 1, close - open - 1));
    hint.remove_prefix(close + 1);
  }
  return true;
}

}  // namespace

std::string hint_fault(std::string_view hint) {
  if (letters(hint) > kHintLetters)
    return "has " + std::to_string(letters(hint)) + " letters; it is one line of " +
           std::to_string(kHintLetters) + " at most";
  std::string fault;
  const bool whole = take_apart(
      hint, [](std::string_view) {},
      [&](std::string_view word) {
        if (fault.empty() && std::ranges::find(kWords, word) == kWords.end())
          fault = "has the word " + in_quotes("{" + std::string(word) + "}") +
                  did_you_mean(word, kWords, "the words in braces are " + joined(kWords));
      });
  if (!whole) return "has a brace without its other; a word in braces is one of " + joined(kWords);
  return fault;
}

std::string hint_text(std::string_view hint, const std::array<std::string_view, 5>& said) {
  std::string text;
  take_apart(
      hint, [&](std::string_view plain) { text += plain; },
      [&](std::string_view word) {
        text += said[static_cast<std::size_t>(std::ranges::find(kWords, word) - kWords.begin())];
      });
  return text;
}

}  // namespace fulcrum::scenario
