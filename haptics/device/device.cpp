#include "haptics/device/device.h"

#include <algorithm>

namespace fulcrum {

double held_fraction(double age) {
  constexpr double hold = 2e-3, fall = 5e-3;
  return std::clamp(1.0 - (age - hold) / fall, 0.0, 1.0);
}

}  // namespace fulcrum
