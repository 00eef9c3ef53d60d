#pragma once
// What a trainee finds in the picture: the ring of the next checkpoint, the mark where the tool touches, the
// arrow that says how deep it has to go, and the ticks in the list.

#include <optional>

#include "tests/person/picture.h"

namespace fulcrum::person {

struct Ring {
  Place middle;          // px
  double radius = 0;     // px
  bool filling = false;  // the tool is in it
};

struct Sight {
  std::optional<Ring> ring;
  std::optional<Place> touch;  // px
  std::optional<Place> lost;   // unit, the way to a tool that is out of the picture
  double farther = 0;          // px that a drag with Shift has to go up; below 0: down; 0: no arrow
  int done = 0;                // ticks in the list of checkpoints
};

Sight look_at(const Picture& picture);

}  // namespace fulcrum::person
