#pragma once
// A Polhem's board on an emulated node: it answers what it hears, as its firmware does, while it is plugged
// in.

#include <atomic>
#include <mutex>
#include <thread>
#include <vector>

#include "haptics/device/device.h"
#include "tests/drivers_mock/mock_hid.h"

namespace fulcrum::test {

// Of content/devices/polhem.yaml, as far as its driver needs it.
DeviceDesc polhem_desc();

class MockPolhem {
public:
  explicit MockPolhem(MockMachine& machine);  // plugged in, at rest, and its button was pressed
  ~MockPolhem();
  MockPolhem(const MockPolhem&) = delete;
  MockPolhem& operator=(const MockPolhem&) = delete;

  // Counts of the first motor's encoder, which turns the arm to the side.
  void turn(int yaw) { yaw_ = yaw; }
  // What it says of them, and since when.
  struct Said {
    int yaw = 0;
    MockHid::Clock::time_point at{};
  };
  Said said();
  void unplug();
  void plug();  // its button is pressed again
  // mA, of the first motor, as it was told last.
  int current() const { return current_in(hid_.last_written()); }
  static int current_in(const Bytes& heard);
  std::size_t times_told() const { return hid_.times_written(); }
  std::vector<Bytes> told() const { return hid_.written(); }
  MockHid::Clock::time_point told_at(std::size_t n) const { return hid_.written_at(n); }

private:
  void answer_on();

  MockHid hid_;
  std::mutex mutex_;
  bool plugged_ = true, asks_ = true;
  std::size_t answered_ = 0;
  std::atomic<bool> on_{true};
  std::atomic<int> yaw_{100};
  Said said_;
  std::thread firmware_;
};

}  // namespace fulcrum::test
