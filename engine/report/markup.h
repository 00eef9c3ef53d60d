#pragma once
// Pieces of HTML and SVG.

#include <string>
#include <string_view>

namespace fulcrum::report {

// Text as it may stand between tags and within quotes. Control characters, which no HTML may hold, become
// U+FFFD.
std::string escaped(std::string_view text);

// A coordinate of a picture, to a hundredth of a pixel.
std::string pixels(double value);

}  // namespace fulcrum::report
