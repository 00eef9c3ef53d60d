#pragma once
// A HID device between its bus and the haptic thread: a thread that reads, one that writes, and the newest of
// each. Nobody here waits for the other. Where the device is unplugged, it is looked for until it is back.

#include <atomic>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <thread>

#include "drivers/hid/hid_port.h"
#include "drivers/hid/hid_protocol.h"
#include "drivers/rate/axes_source.h"
#include "haptics/loop/snapshot.h"

namespace fulcrum::hid {

// A port, and what is spoken there: a pad speaks differently by USB and by Bluetooth.
struct HidOpened {
  std::unique_ptr<HidPort> port;
  std::unique_ptr<HidProtocol> protocol;
};

class HidLink final : public AxesSource {
public:
  // Null ports where the device is not there; asked by the reading thread.
  using Open = std::function<HidOpened()>;

  // opened: now. open: for when it is lost.
  HidLink(HidOpened opened, Open open);
  ~HidLink() override;  // the motors rest; then the threads end
  HidLink(const HidLink&) = delete;
  HidLink& operator=(const HidLink&) = delete;

  // The haptic thread.
  AxesReading read() noexcept override;
  void drive(const ChannelDrives& drives) noexcept override;

  // Reports that were understood, and others, since the beginning.
  std::uint64_t reports() const { return reports_.load(std::memory_order_relaxed); }
  std::uint64_t refused() const { return refused_.load(std::memory_order_relaxed); }

private:
  struct State {
    PushedAxes axes{};
    std::int64_t told_ns = 0;  // when it last said what the axes are
    std::int64_t seen_ns = 0;  // when it was last known to be there
    bool connected = true;
    bool streams = false;
  };
  void read_on();
  void write_on();
  // False: the port is gone.
  bool take_reports(HidOpened& opened, State& state);
  std::shared_ptr<HidOpened> opened();
  // None: the device is away.
  void set_opened(std::shared_ptr<HidOpened> opened);
  // False: it is to end.
  bool rest(int ms);

  Open open_;
  Snapshot<State> state_;
  struct Told {
    ChannelDrives drives{};
    std::int64_t at_ns = 0;
  };
  ChannelDrives due();  // what is left of the newest ones
  Snapshot<Told> told_;
  std::atomic<std::uint64_t> reports_{0}, refused_{0};

  std::mutex mutex_;  // of the two threads below; never the haptic one's
  std::condition_variable ended_;
  bool ends_ = false;
  std::shared_ptr<HidOpened> opened_;  // null while the device is away
  std::thread reader_, writer_;
};

}  // namespace fulcrum::hid
