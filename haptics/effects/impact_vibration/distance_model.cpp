#include "haptics/effects/impact_vibration/distance_model.h"

#include <algorithm>

#include "haptics/math/functions.h"

namespace fulcrum {
namespace {

constexpr double kLowest_Hz = 12;
constexpr double kMinOfFirst = 0.1;
constexpr double kBetaL[] = {1.8751040687119611, 4.6940911329741746, 7.8547574382376126};

// At x = part L; +-2 at the free end.
double mode_shape(double beta_L, double part) {
  const double sigma = (math::cosh(beta_L) + math::cos(beta_L)) / (math::sinh(beta_L) + math::sin(beta_L));
  const double b = beta_L * part;
  return math::cosh(b) - math::cos(b) - sigma * (math::sinh(b) - math::sin(b));
}

}  // namespace

VibrationModes vibration_modes(DistanceModel model, double frequency_Hz, double r, double reach) noexcept {
  const double part = reach > 0 ? std::clamp(r / reach, 0.0, 1.0) : 1.0;
  VibrationModes result;
  if (model == DistanceModel::sinusoid) {
    const double lowest = std::min(kLowest_Hz, frequency_Hz);
    result.modes[result.count++] = {lowest + (frequency_Hz - lowest) * (1 - part), 1.0};
    return result;
  }
  for (const double beta_L : kBetaL) {
    const double ratio = beta_L / kBetaL[0];
    result.modes[result.count++] = {frequency_Hz * ratio * ratio, mode_shape(beta_L, part) / 2};
  }
  result.modes[0].amplitude = std::max(result.modes[0].amplitude, kMinOfFirst);
  return result;
}

}  // namespace fulcrum
