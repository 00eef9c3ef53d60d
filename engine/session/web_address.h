#pragma once
// Where a service on the web is, as a person typed it.

#include <string>

#include "haptics/math/result.h"

namespace fulcrum::session {

struct WebAddress {
  std::string text{};      // without a slash at its end
  bool encrypted = false;  // https
  bool loopback = false;   // this machine's own, by the names that are never looked up
};

// http or https, a host, and a path at most. Refused: a user or a password, since an address is shown and
// remembered by shells; a question and a fragment, since more is added at the end; and any byte that is not
// of an address. Errors are clauses that the caller's sentence ends in, and never repeat what was typed.
Result<WebAddress> web_address(const std::string& typed);

// A whole address without user and password: libcurl puts them into the one that it makes of a redirect.
// Empty: it is none.
std::string without_user(const char* address);

}  // namespace fulcrum::session
