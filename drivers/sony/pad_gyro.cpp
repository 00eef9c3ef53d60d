#include "drivers/sony/pad_gyro.h"

#include <algorithm>
#include <numbers>

namespace fulcrum::sony {
namespace {

constexpr double kStep = 2000 * std::numbers::pi / 180 / 32768;  // rad/s
constexpr double kMostOff = 0.05;                                // rad/s, that a gyroscope shows at rest
constexpr int kStillFrom = 100;    // reports: then it is rest and no turn in passing
constexpr double kFollow = 0.005;  // of the way, with each report

}  // namespace

Vec3 PadGyro::rate(const std::array<std::int16_t, 3>& readings, bool in_use) noexcept {
  const Vec3 shown = kStep * Vec3(readings[0], readings[1], readings[2]);
  const bool still = !in_use && shown.cwiseAbs().maxCoeff() < kMostOff;
  still_ = still ? std::min(still_ + 1, kStillFrom) : 0;
  if (still_ == kStillFrom) off_ += kFollow * (shown - off_);
  return shown - off_;
}

}  // namespace fulcrum::sony
