#pragma once
// A device with motors between its bus and the haptic thread. One thread of its own exchanges commands for
// samples, as fast as the bus goes; the haptic thread leaves the newest command and takes the newest sample,
// and never waits. A command that nobody renews is let go (held_command), whatever the haptic thread is
// doing. Where the device is unplugged, it is looked for until it is back.

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "drivers/force/force_bus.h"
#include "haptics/device/device.h"
#include "haptics/loop/snapshot.h"
#include "haptics/math/result.h"

namespace fulcrum {

class ForceDevice final : public Device {
public:
  // Null where the device is not there.
  using Open = std::function<std::unique_ptr<ForceBus>()>;

  // Waits for the first sample, a second at most once the bus is ready. Errors: none came, and why. bus: not
  // null.
  static Result<std::unique_ptr<ForceDevice>> start(const DeviceDesc& desc, std::unique_ptr<ForceBus> bus,
                                                    Open open);
  ~ForceDevice() override;  // the motors rest; then the thread ends
  ForceDevice(const ForceDevice&) = delete;
  ForceDevice& operator=(const ForceDevice&) = delete;

  // The haptic thread.
  const DeviceDesc& desc() const override { return desc_; }
  DeviceSample read() noexcept override;
  void write(const DeviceCommand& command) noexcept override;
  void miss(int) noexcept override {}  // a command grows old by itself

  // Turns of the bus that brought a sample, since the beginning.
  std::uint64_t turns() const { return turns_.load(std::memory_order_relaxed); }

private:
  struct Seen {
    DeviceSample sample{};
    std::int64_t at_ns = 0;
  };
  struct Told {
    DeviceCommand command{};
    std::int64_t at_ns = 0;
  };
  ForceDevice(const DeviceDesc& desc, std::unique_ptr<ForceBus> bus, Open open, const DeviceSample& first);
  void exchange_on(DeviceSample sample);
  void let_rest();
  DeviceCommand due();  // what is left of the newest command
  void show(const DeviceSample& sample);
  bool rest(int ms);  // false: it is to end

  DeviceDesc desc_;
  Open open_;
  Snapshot<Seen> seen_;
  Snapshot<Told> told_;
  std::atomic<std::uint64_t> turns_{0};

  std::mutex mutex_;  // of the thread below and of who ends it; never the haptic thread's
  std::condition_variable ended_;
  bool ends_ = false;
  std::unique_ptr<ForceBus> bus_;  // the thread's own; null while the device is away
  std::thread thread_;
};

}  // namespace fulcrum
