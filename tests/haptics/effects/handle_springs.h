#pragma once
// What the tests of springs at the handle share: a device of round figures, and the border of stability of
// its handle under a force that is held from tick to tick.

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "haptics/device/device.h"
#include "tests/haptics/tick_length.h"

namespace fulcrum::test {

// Of round figures, and linear.
inline DeviceDesc frictionless_device() {
  DeviceDesc device;
  device.max_force = 8;
  device.handle_mass = 0.1;
  device.handle_weight = 0;
  device.damping = 0.5;
  device.friction = device.angular_friction = 0;
  device.encoder_step = device.encoder_step_rad = 0;
  return device;
}

// m and N along x: where a handle rests under a steady press towards +x.
struct PressedHandle {
  double rest = 0, press = 0;
};

// m, how far a handle still swings after 7.5 s that was 1 um from rest. Exactly, over each tick in which the
// spring's force is held, `late` ticks after it was found. spring(x, its change in this tick), m: N along x.
template <class Spring>
double swing_left(const DeviceDesc& device, const PressedHandle& handle, std::size_t late, Spring&& spring) {
  const double m = device.handle_mass, b = device.damping, e = std::exp(-b / m * kTick);
  double x = handle.rest + 1e-6, v = 0, swing = 0, before = x;
  std::vector<double> waiting(late, -handle.press);
  for (int i = 0; i < 8000; ++i) {
    waiting.push_back(spring(x, x - before));
    before = x;
    const double settled = (handle.press + waiting.front()) / b;  // m/s
    waiting.erase(waiting.begin());
    x += settled * kTick + (v - settled) * m / b * (1 - e);
    v = settled + (v - settled) * e;
    if (i >= 7500) swing = std::max(swing, std::abs(x - handle.rest));
  }
  return swing;
}

}  // namespace fulcrum::test
