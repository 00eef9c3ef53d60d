#pragma once
// A USB device that is not there, for the real libusb: umockdev shows it the files of /sys and the node of
// usbfs, and asks here what it asks of the node. What the device does is the model's. The program must begin
// by umockdev-wrapper.
//
// umockdev's node can always be polled, so that libusb asks again and again whether something is done: how
// fast anything is here says nothing.

#include <linux/usbdevice_fs.h>
#include <umockdev.h>

#include <cstdint>
#include <deque>
#include <mutex>
#include <string>
#include <vector>

#include "tests/device_models/falcon_model.h"
#include "tests/drivers_mock/mock_hid.h"

namespace fulcrum::test {

// Outlives every handle to it that is open.
class MockUsb {
public:
  // Plugged in. serial: empty, it has none. wanders: it is plugged in at another port each time.
  MockUsb(MockMachine& machine, FalconModel& model, std::string serial = "", bool wanders = false);
  ~MockUsb();
  MockUsb(const MockUsb&) = delete;
  MockUsb& operator=(const MockUsb&) = delete;

  void plug();
  void unplug();
  const std::string& node() const { return node_; }  // where it was plugged in last
  void claim_elsewhere(bool claimed);                // another program holds it
  void garble_in(bool garbles);                      // what it says arrives damaged; it hears as before
  bool is_claimed() const;
  std::size_t live() const;  // transfers that libusb has not got back

private:
  // A transfer of libusb's: its block, and the buffer that it points to, in the memory of the program.
  struct Transfer {
    gulong address = 0;
    UMockdevIoctlData* block = nullptr;
    UMockdevIoctlData* buffer = nullptr;
  };
  static gboolean on_ioctl(UMockdevIoctlBase*, UMockdevIoctlClient* client, gpointer self);
  void answer(UMockdevIoctlClient* client);
  int claim(bool claims);
  int submit(UMockdevIoctlClient* client);
  int discard(UMockdevIoctlClient* client);
  int reap(UMockdevIoctlClient* client);
  void finish(Transfer transfer, int status, const Bytes& read, int length);
  void finish_all(int status);

  MockMachine& machine_;
  FalconModel& model_;
  UMockdevIoctlBase* const handler_;
  const std::string serial_;
  const bool wanders_;
  int port_ = 0;  // 0: it was never plugged in
  std::string path_, node_;
  std::vector<std::string> nodes_;  // those that it has had

  mutable std::mutex mutex_;  // umockdev asks from a thread of its own
  bool plugged_ = false, claimed_ = false, elsewhere_ = false, garbles_ = false;
  std::deque<Transfer> waiting_;  // for what the device says
  std::deque<Transfer> done_;     // for libusb to take back
  int idle_reaps_ = 0;
};

}  // namespace fulcrum::test
