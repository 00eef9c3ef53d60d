#pragma once
// What a trainee knows of a scene who has seen it once: which view shows it best, and what is in the way.

#include <string>
#include <vector>

#include "tests/person/picture.h"

namespace fulcrum::person {

// The way to a checkpoint, in heights of the picture, y down.
struct Leg {
  Place detour;     // where the tool draws back to first, and from where beside the ring it comes; (0, 0):
                    // straight
  double roll = 0;  // clockwise, a drag so long with Shift and the right button, before the tool goes in
  bool touches = false;  // within the ring, the tool goes on until it touches
  bool stops = false;    // within the ring, force and time are stopped for a moment
};

struct Plan {
  std::string scene;
  char view = 0;  // its key; 0: the one that the scene begins with
  // How much nearer to the person the tool goes from place to place than these are, in heights of the
  // picture.
  double clearance = 0;
  std::vector<Leg> legs;  // (n) one for each checkpoint, in order
};

// Null: none is known.
const Plan* find_plan(const std::string& scene);

}  // namespace fulcrum::person
