#pragma once
// What a trainee knows of a scene who has seen it once: which view shows it best, and what is in the way.

#include <string>
#include <vector>

#include "tests/person/picture.h"

namespace fulcrum::person {

struct Plan {
  std::string scene;
  char view = 0;  // its key; 0: the one that the scene begins with
  // How much nearer to the person the tool goes from place to place than these are, in heights of the
  // picture.
  double clearance = 0;
  // (n) of each checkpoint, in order: where the tool draws back to first, and from where beside the ring it
  // comes. In heights of the picture, y down; (0, 0): nothing is in the way.
  std::vector<Place> detours;
};

// Null: none is known.
const Plan* find_plan(const std::string& scene);

}  // namespace fulcrum::person
