#pragma once
// An omega.6 by its maker's library, a thousand times a second.

#include <chrono>
#include <memory>
#include <string>

#include "drivers/force/force_bus.h"
#include "drivers/omega/dhd_library.h"

namespace fulcrum::dhd {

// Why none can be opened now; empty: one is there.
std::string why_no_omega();

class OmegaBus final : public ForceBus {
public:
  // Errors: it cannot be opened, in the library's words.
  static Result<std::unique_ptr<OmegaBus>> open();
  ~OmegaBus() override;
  OmegaBus(const OmegaBus&) = delete;
  OmegaBus& operator=(const OmegaBus&) = delete;

  Turn exchange(const DeviceCommand& command, DeviceSample& sample) override;
  std::string trouble() const override;

private:
  OmegaBus(const Library& dhd, char device) : dhd_(dhd), device_(device) {}

  const Library& dhd_;
  char device_;
  std::chrono::steady_clock::time_point due_{};  // of the next turn
  bool calibrated_ = false;
};

}  // namespace fulcrum::dhd
