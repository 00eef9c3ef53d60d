#pragma once
// Hints: what to do at a checkpoint, in a sentence that leaves to the device in hand how it is done there.

#include <array>
#include <string>
#include <string_view>

#include "haptics/math/names_of.h"

namespace fulcrum::scenario {

// What stands in braces in a hint, and is said of a device as a clause: "Go to the nut: {move}." becomes "Go
// to the nut: push the cap."
enum class HintWord { move, turn, finely, stop, go_on };

inline constexpr std::size_t kHintLetters = 110;  // of a hint as it is written, at most

// What is wrong with a hint, as a rule's sentence; empty: nothing.
std::string hint_fault(std::string_view hint);

// The sentence for a device. said: of each word, in the order of HintWord. A hint that hint_fault() has
// passed.
std::string hint_text(std::string_view hint, const std::array<std::string_view, 5>& said);

}  // namespace fulcrum::scenario

template <>
inline constexpr std::array<std::string_view, 5> fulcrum::names_of<fulcrum::scenario::HintWord>{
    "move", "turn", "finely", "stop", "go_on"};
