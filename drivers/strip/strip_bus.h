#pragma once
// A strip on its USB port. It is told nothing, and says what it read each millisecond; a sample of it is its
// reading alone.

#include <memory>
#include <optional>

#include "drivers/force/force_bus.h"
#include "drivers/hid/hid_port.h"
#include "drivers/strip/strip_reports.h"

namespace fulcrum::strip {

class StripBus final : public ForceBus {
public:
  StripBus(std::unique_ptr<hid::HidPort> port, const DeviceDesc& /*desc*/) : port_(std::move(port)) {}

  // Fresh: the strip was read anew. What repeats itself, or the time of its reading, is none, and so is what
  // the board says first, before another report has shown that it goes on.
  Turn exchange(const DeviceCommand&, DeviceSample& sample) override;
  std::string trouble() const override;

private:
  std::unique_ptr<hid::HidPort> port_;
  std::optional<StripSays> last_;  // whatever it was worth
  bool spoke_ = false;
};

}  // namespace fulcrum::strip
