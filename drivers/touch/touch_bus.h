#pragma once
// A Touch by its maker's library, which calls back a thousand times a second in a thread of its own.

#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>

#include "drivers/force/force_bus.h"
#include "drivers/touch/hd_library.h"

namespace fulcrum::hd {

// Why none can be opened now; empty: one is there.
std::string why_no_touch();

class TouchBus final : public ForceBus {
public:
  // Errors: it cannot be opened, in the library's words.
  static Result<std::unique_ptr<TouchBus>> open();
  ~TouchBus() override;
  TouchBus(const TouchBus&) = delete;
  TouchBus& operator=(const TouchBus&) = delete;

  Turn exchange(const DeviceCommand& command, DeviceSample& sample) override;
  std::string trouble() const override;

private:
  TouchBus(const Library& hd, unsigned device);
  static unsigned on_frame(void* self);
  void frame();

  const Library& hd_;
  unsigned device_;
  unsigned long callback_ = 0;

  mutable std::mutex mutex_;  // of the library's thread and of who exchanges
  std::condition_variable framed_;
  DeviceCommand command_;
  double command_age_ = 0;  // s, in frames: a command that nobody renews is let go
  DeviceSample sample_;
  bool fresh_ = false, lost_ = false, calibrated_ = false;
};

}  // namespace fulcrum::hd
