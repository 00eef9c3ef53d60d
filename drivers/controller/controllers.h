#pragma once
// What hands do in a headset, as its main thread and the haptic thread share it: where the handle is to be
// comes from the one, how a pair of controllers vibrates from the other.

#include <array>
#include <atomic>
#include <cstddef>

#include "drivers/rate/axes_source.h"
#include "haptics/loop/snapshot.h"
#include "haptics/math/pose.h"

namespace fulcrum {

inline constexpr std::size_t kHands = 2;  // left, right

// Where hands want the handle.
struct WantedHandle {
  Pose X_DH;
  bool seen = true;  // false: the hand that holds it is out of sight, and the pose is the last one known
};

class Controllers final : public AxesSource {
public:
  explicit Controllers(double carrier_Hz) : carrier_Hz_(carrier_Hz) {}

  // Main thread: from here on.
  void move(const WantedHandle& handle) noexcept;
  // Main thread: how strongly each is to vibrate, 0 to 1, and at which frequency.
  std::array<double, kHands> strengths() const noexcept;
  double carrier_Hz() const { return carrier_Hz_; }

  // Haptic thread.
  const WantedHandle& wanted() noexcept { return wanted_.newest(); }
  AxesReading read() noexcept override { return {}; }  // nothing of them is pushed
  void drive(const ChannelDrives& drives) noexcept override;

private:
  double carrier_Hz_;
  Snapshot<WantedHandle> wanted_;
  std::array<std::atomic<double>, kHands> strengths_{};
};

}  // namespace fulcrum
