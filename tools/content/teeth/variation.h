#pragma once
// No two teeth of a jaw are alike: how one differs from its kind, in size and in how it stands.

#include <random>

namespace fulcrum::content {

struct Variation {
  double size = 1.0;     // of the kind's
  double turn = 0.0;     // rad, about its own axis
  double inward = 0.0;   // rad, of the crown to lingual
  double mesial = 0.0;   // rad, of the crown to mesial
  double outward = 0.0;  // mm, off the line of the arch
  double up = 0.0;       // mm, over the occlusal curve
  double phase = 0.0;    // rad, of the waves in its grooves
};

// One tooth after the other, the same every time.
class Variations {
public:
  Variation next();

private:
  double within(double most);  // -most to most

  std::mt19937 random_{1};  // its numbers, unlike those of distributions, are the same in every library
};

}  // namespace fulcrum::content
