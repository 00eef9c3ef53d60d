#include "haptics/device/device.h"

#include <algorithm>

namespace fulcrum {

double held_fraction(double age) {
  constexpr double hold = 2e-3, fall = 5e-3;
  return std::clamp(1.0 - (age - hold) / fall, 0.0, 1.0);
}

DeviceCommand held_command(const DeviceCommand& command, double age) {
  const double left = held_fraction(age);
  DeviceCommand held;
  held.F_H_D = command.F_H_D * left;
  std::ranges::transform(command.effort, held.effort.begin(),
                         [left](double effort) { return left * effort; });
  return held;
}

}  // namespace fulcrum
