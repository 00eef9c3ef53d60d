#pragma once
// Whether a text is UTF-8, RFC 3629: tapes and results are, and keep what a person's files say.

#include <cstddef>
#include <string_view>

namespace fulcrum {

// How many bytes from the text's beginning on are UTF-8; text.size(): all of it is.
std::size_t utf8_bytes(std::string_view text);

}  // namespace fulcrum
