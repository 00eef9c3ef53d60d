#pragma once
// Pieces of HTML and SVG.

#include <string>
#include <string_view>

namespace fulcrum::report {

// Text as it may stand between tags and within quotes. Control characters, which no HTML may hold, become
// U+FFFD.
std::string escaped(std::string_view text);

// Bytes as they may stand in an address (RFC 4648, section 4).
std::string base64(std::string_view bytes);

// A coordinate of a picture, to a hundredth of a pixel.
std::string pixels(double value);

}  // namespace fulcrum::report
