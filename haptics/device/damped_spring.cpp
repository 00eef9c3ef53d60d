#include "haptics/device/damped_spring.h"

#include <algorithm>
#include <cmath>

#include "haptics/device/linear_loop.h"
#include "haptics/math/bisect.h"
#include "haptics/math/functions.h"

namespace fulcrum {
namespace {

constexpr double kSpringLimitShare = 0.25;                      // of the limit, where no stiffness is given
constexpr double kSoftestSpring = 1e-3, kStiffestSpring = 1e9;  // N/m, where the search begins and ends
constexpr double kSpringPrecision = 1e-4;                       // of the limit
constexpr double kMostSpringDelay = 8;                          // ticks

double spring_damping_for(double K, const DeviceDesc& device) {
  return 2 * DampedSpring::kDampingRatio * std::sqrt(K * device.handle_mass);
}

double spring_pole_of(double tick_s) {
  return math::exp(-tick_s / DampedSpring::kSmoothing);
}

// A device with a rate of its own is as late as its samples may be old.
int spring_delay_of(const DeviceDesc& device, double tick_s) {
  if (device.sample_rate_Hz <= 0) return 0;
  return static_cast<int>(std::min(kMostSpringDelay, std::ceil(1 / (device.sample_rate_Hz * tick_s))));
}

}  // namespace

double DampedSpring::limit(const DeviceDesc& device, double tick_s) {
  const WallLoop loop{.axis = {.mass = device.handle_mass, .damping = device.damping},
                      .tick_s = tick_s,
                      .delay_ticks = spring_delay_of(device, tick_s),
                      .filter_pole = spring_pole_of(tick_s)};
  return end_above(kSoftestSpring, kSpringPrecision, [&](double K) {
    return K < kStiffestSpring && exact_growth(loop, {.K = K, .B = spring_damping_for(K, device)}) < 0;
  });
}

double DampedSpring::suited(const DeviceDesc& device, double tick_s, double largest) {
  double K = std::min(largest, kSpringLimitShare * limit(device, tick_s));
  if (device.friction > 0 && device.encoder_step > 0)
    K = std::min(K, 2 * device.friction / device.encoder_step);
  return K;
}

DampedSpring::DampedSpring(double stiffness, double max_force, const DeviceDesc& device, double tick_s)
    : stiffness_(stiffness),
      max_force_(max_force),
      damping_(spring_damping_for(stiffness, device)),
      pole_(spring_pole_of(tick_s)),
      tick_s_(tick_s) {}

double DampedSpring::push(double s, const Vec3& dhat_D) const noexcept {
  return std::clamp(stiffness_ * s + damping_ * velocity_D_.dot(dhat_D), 0.0, max_force_);
}

double DampedSpring::stored(double s) const noexcept {
  const double whole = max_force_ / stiffness_;  // m, from where on the force grows no more
  const double bent = std::min(s, whole);
  return stiffness_ * bent * bent / 2 + max_force_ * (s - bent);
}

}  // namespace fulcrum
