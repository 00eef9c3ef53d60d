#pragma once
// Where along a positive quantity something ceases to hold.

#include <cmath>

namespace fulcrum {

// Halves the ratio between a value at which `holds` and one at which not, until they differ by `precision` of
// their size.
template <class Holds>
double bisect(double good, double bad, double precision, const Holds& holds) {
  while (std::abs(bad - good) > precision * bad) {
    const double middle = std::sqrt(good * bad);
    (holds(middle) ? good : bad) = middle;
  }
  return std::sqrt(good * bad);
}

// The first end of what holds, from `start` upwards; 0 if it does not hold there. It has to end somewhere.
template <class Holds>
double end_above(double start, double precision, const Holds& holds) {
  if (!holds(start)) return 0;
  double good = start, bad = 1.5 * start;
  while (holds(bad)) {
    good = bad;
    bad *= 1.5;
  }
  return bisect(good, bad, precision, holds);
}

// The last end of it, from `start`, where it does not hold, downwards; 0 if it holds nowhere above `least`.
template <class Holds>
double end_below(double start, double least, double precision, const Holds& holds) {
  double bad = start;
  for (double good = start / 2; good >= least; good /= 2) {
    if (holds(good)) return bisect(good, bad, precision, holds);
    bad = good;
  }
  return 0;
}

}  // namespace fulcrum
