#pragma once
// What the fuzzers of scenarios, of the files that a scenario names and of --set share: a small scenario to
// damage, and what any answer of the loader has to be.

#include <string>
#include <string_view>

#include "engine/scenario/load.h"

namespace fulcrum::scenario::fuzz {

// The scenario of tests/scenario/example.h with everything that it names; `input` is the text of `file`.
SourceTexts example_with(const std::string& file, std::string_view input);

// Aborts unless `answer`, to `texts`, is a scenario that is sound, or faults that say something and point
// into a text.
void expect_answer(const Checked<Scenario>& answer, const SourceTexts& texts);

// Reads the example with `input` as the text of `file`, and expects an answer.
void read_example_with(const std::string& file, std::string_view input);

}  // namespace fulcrum::scenario::fuzz
