#pragma once
// The rules of the Experience API 1.0.3 for a statement, part two of https://github.com/adlnet/xAPI-Spec,
// written apart from what sends them: all that a store must refuse, and what a provider should not send.
// Attachments, substatements and interactions are not known here, and refused as well.

#include <string>
#include <string_view>
#include <vector>

namespace fulcrum::test {

// What breaks the rules, "result.score.scaled: ..." each; nothing: it keeps them all.
std::vector<std::string> xapi_faults(std::string_view statement_json);

}  // namespace fulcrum::test
