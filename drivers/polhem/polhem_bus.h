#pragma once
// A Polhem on its USB port. It answers a report of currents with one of counts, a thousand times a second.
// Its firmware switches the motors off where nothing has come for half a second.

#include <memory>

#include "drivers/force/force_bus.h"
#include "drivers/hid/hid_port.h"
#include "drivers/polhem/polhem_arm.h"

namespace fulcrum::polhem {

class PolhemBus final : public ForceBus {
public:
  PolhemBus(std::unique_ptr<hid::HidPort> port, const DeviceDesc& desc);

  Turn exchange(const DeviceCommand& command, DeviceSample& sample) override;
  std::string trouble() const override;

private:
  std::unique_ptr<hid::HidPort> port_;
  PolhemArm arm_;
  bool calibrates_ = false;  // the board is to be told so
  bool calibrated_ = false;
  bool spoke_ = false;
  bool other_ = false;  // what it says is no Polhem's
};

}  // namespace fulcrum::polhem
