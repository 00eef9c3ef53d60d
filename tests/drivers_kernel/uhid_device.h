#pragma once
// A model of a device, plugged into this machine's own kernel as Bluetooth plugs it in: by /dev/uhid, where a
// program stands for the far end of the link. Needs root.

#include <atomic>
#include <thread>

#include "tests/device_models/hid_model.h"

namespace fulcrum::test {

class UhidDevice {
public:
  // Plugged in. model: outlives it.
  explicit UhidDevice(HidModel& model);
  ~UhidDevice();
  UhidDevice(const UhidDevice&) = delete;
  UhidDevice& operator=(const UhidDevice&) = delete;

private:
  void serve();
  void take_event();

  HidModel& model_;
  int file_ = -1;
  std::atomic<bool> on_{true};
  bool started_ = false;
  std::thread thread_;
};

}  // namespace fulcrum::test
