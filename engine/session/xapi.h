#pragma once
// A statement in the form of the Experience API 1.0.3, part two (https://github.com/adlnet/xAPI-Spec), which
// learning record stores take.

#include <string>
#include <string_view>

#include "engine/session/statement.h"

namespace fulcrum::session {

// The same statement gives the same text, always. home_page: an address in the form of web_address(), of the
// school or firm whose pseudonyms these are. What no vocabulary has a word for is named below it, since an
// address is nobody else's: HOME/xapi/scenarios/NAME, HOME/xapi/extensions/NAME.
//
// A scenario or device that was named by a file goes out under the file's name alone. What is no number is
// left out.
std::string statement_json(const Statement& statement, std::string_view home_page);

}  // namespace fulcrum::session
