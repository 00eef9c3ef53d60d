#pragma once
// The pair of controllers of a headset, as its main thread and the haptic thread share them: where the handle
// is to be comes from the one, how the two vibrate from the other.

#include <array>
#include <atomic>
#include <cstddef>
#include <cstdint>

#include "drivers/rate/axes_source.h"
#include "haptics/loop/snapshot.h"
#include "haptics/math/pose.h"

namespace fulcrum {

inline constexpr std::size_t kHands = 2;  // left, right

// What the hands want of the handle.
struct HandleInHand {
  Pose X_DH;
  std::uint32_t buttons = 0;
};

class Controllers final : public AxesSource {
public:
  // Of DeviceSample::buttons.
  static constexpr std::uint32_t kHold = 1, kStop = 2;

  explicit Controllers(double carrier_Hz) : carrier_Hz_(carrier_Hz) {}

  // Main thread: from here on.
  void move(const HandleInHand& wanted) noexcept;
  // Main thread: how strongly each is to vibrate, 0 to 1, and at which frequency.
  std::array<double, kHands> strengths() const noexcept;
  double carrier_Hz() const { return carrier_Hz_; }

  // Haptic thread.
  const HandleInHand& wanted() noexcept { return wanted_.newest(); }
  AxesReading read() noexcept override { return {}; }  // nothing of them is pushed
  void drive(const ChannelDrives& drives) noexcept override;

private:
  double carrier_Hz_;
  Snapshot<HandleInHand> wanted_;
  std::array<std::atomic<double>, kHands> strengths_{};
};

}  // namespace fulcrum
