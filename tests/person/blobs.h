#pragma once
// Patches of one colour in a picture.

#include <cstddef>
#include <span>
#include <vector>

#include "tests/person/picture.h"

namespace fulcrum::person {

struct Blob {
  std::vector<Place> pixels;
  double left = 0, top = 0, right = 0, bottom = 0;  // px, of its outermost pixels

  double width() const { return right - left + 1; }
  double height() const { return bottom - top + 1; }
  Place middle() const { return {(left + right) / 2, (top + bottom) / 2}; }
};

// (n) for each colour: its pixels, no farther than `tolerance` from it in any channel, joined where they
// touch, corners included. Colours farther apart than that are never joined.
std::vector<std::vector<Blob>> find_blobs(const Picture& picture, std::span<const Colour> colours,
                                          int tolerance);

}  // namespace fulcrum::person
