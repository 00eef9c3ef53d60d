#include "drivers/controller/controllers.h"

namespace fulcrum {

void Controllers::move(const WantedHandle& handle) noexcept {
  wanted_.draft() = handle;
  wanted_.publish();
}

std::array<double, kHands> Controllers::strengths() const noexcept {
  return {strengths_[0].load(std::memory_order_relaxed), strengths_[1].load(std::memory_order_relaxed)};
}

// The table has the left one's channel first.
void Controllers::drive(const ChannelDrives& drives) noexcept {
  for (std::size_t hand = 0; hand < kHands; ++hand)
    strengths_[hand].store(drives[hand], std::memory_order_relaxed);
}

}  // namespace fulcrum
