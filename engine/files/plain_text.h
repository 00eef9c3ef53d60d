#pragma once
// Text from elsewhere, as a statement and a terminal may have it.

#include <cstddef>
#include <string>
#include <string_view>

namespace fulcrum {

// Always UTF-8. A byte that is no part of a character becomes U+FFFD; a character that controls, breaks lines
// or turns the direction of writing becomes a space.
std::string plain_text(std::string_view text);

// Of that the beginning, with "..." where it is longer than `most` bytes.
std::string short_text(std::string_view text, std::size_t most);

}  // namespace fulcrum
