#pragma once
// The pair of controllers of a headset, as its main thread and the haptic thread share them: where the handle
// is to be comes from the one, how the two vibrate from the other.

#include <array>
#include <atomic>
#include <cstddef>

#include "drivers/rate/axes_source.h"
#include "haptics/loop/snapshot.h"
#include "haptics/math/pose.h"

namespace fulcrum {

inline constexpr std::size_t kHands = 2;  // left, right

class Controllers final : public AxesSource {
public:
  explicit Controllers(double carrier_Hz) : carrier_Hz_(carrier_Hz) {}

  // Main thread: where the hands want the handle from here on.
  void move(const Pose& X_DH) noexcept;
  // Main thread: how strongly each is to vibrate, 0 to 1, and at which frequency.
  std::array<double, kHands> strengths() const noexcept;
  double carrier_Hz() const { return carrier_Hz_; }

  // Haptic thread.
  const Pose& wanted_X_DH() noexcept { return wanted_X_DH_.newest(); }
  AxesReading read() noexcept override { return {}; }  // nothing of them is pushed
  void drive(const ChannelDrives& drives) noexcept override;

private:
  double carrier_Hz_;
  Snapshot<Pose> wanted_X_DH_;
  std::array<std::atomic<double>, kHands> strengths_{};
};

}  // namespace fulcrum
