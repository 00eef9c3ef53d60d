#include "drivers/force/force_device.h"

#include <chrono>
#include <utility>

#include "haptics/loop/age_clock.h"
#include "haptics/loop/real_time.h"

namespace fulcrum {
namespace {

// A turn that returns at once, whatever the reason, must not keep a processor busy that nothing else may
// have.
constexpr std::int64_t kShortestTurn_ns = 100'000;
constexpr int kLookAgain_ms = 250;                 // between two looks for a device that is away
constexpr std::int64_t kFirst_ns = 1'000'000'000;  // for the first sample
constexpr int kLastTurns = 5;                      // of rest, at the end: one may be lost

double seconds_since(std::int64_t then_ns) noexcept {
  return 1e-9 * static_cast<double>(std::max<std::int64_t>(AgeClock::now_ns() - then_ns, 0));
}

}  // namespace

Result<std::unique_ptr<ForceDevice>> ForceDevice::start(const DeviceDesc& desc, std::unique_ptr<ForceBus> bus,
                                                        Open open) {
  DeviceSample first;
  std::int64_t begun = AgeClock::now_ns();
  ForceBus::Turn turn = ForceBus::Turn::none;
  while (turn == ForceBus::Turn::none && AgeClock::now_ns() - begun < kFirst_ns) {
    turn = bus->exchange({}, first);
    if (bus->starts()) begun = AgeClock::now_ns();
  }
  if (turn == ForceBus::Turn::fresh)
    return std::unique_ptr<ForceDevice>(new ForceDevice(desc, std::move(bus), std::move(open), first));
  if (std::string trouble = bus->trouble(); !trouble.empty()) return Error{std::move(trouble)};
  return Error{turn == ForceBus::Turn::lost ? "it was unplugged while it was opened."
                                            : "it is plugged in, and says nothing: is it switched on?"};
}

ForceDevice::ForceDevice(const DeviceDesc& desc, std::unique_ptr<ForceBus> bus, Open open,
                         const DeviceSample& first)
    : desc_(desc), open_(std::move(open)), bus_(std::move(bus)) {
  show(first);
  thread_ = std::thread([this, first] { exchange_on(first); });
}

ForceDevice::~ForceDevice() {
  {
    const std::lock_guard lock(mutex_);
    ends_ = true;
  }
  ended_.notify_all();
  thread_.join();
}

DeviceSample ForceDevice::read() noexcept {
  const Seen& seen = seen_.newest();
  DeviceSample sample = seen.sample;
  sample.age += seconds_since(seen.at_ns);
  return sample;
}

void ForceDevice::write(const DeviceCommand& command) noexcept {
  told_.draft() = {command, AgeClock::now_ns()};
  told_.publish();
}

DeviceCommand ForceDevice::due() {
  const Told& told = told_.newest();
  return held_command(told.command, seconds_since(told.at_ns));
}

void ForceDevice::show(const DeviceSample& sample) {
  seen_.draft() = {sample, AgeClock::now_ns()};
  seen_.publish();
}

bool ForceDevice::rest(int ms) {
  std::unique_lock lock(mutex_);
  return !ended_.wait_for(lock, std::chrono::milliseconds(ms), [this] { return ends_; });
}

void ForceDevice::exchange_on(DeviceSample sample) {
  ask_for_scheduling(kReaderPriority);  // where it is refused, the haptic thread has said so
  std::int64_t last_ns = 0;
  const auto pause_ms = [&] {
    const std::int64_t now = AgeClock::now_ns();
    return now - std::exchange(last_ns, now) < kShortestTurn_ns ? 1 : 0;
  };
  while (rest(pause_ms())) {
    if (!bus_) {
      if (!rest(kLookAgain_ms)) return;
      bus_ = open_();
      continue;
    }
    const ForceBus::Turn turn = bus_->exchange(due(), sample);
    if (turn == ForceBus::Turn::none) continue;
    sample.connected = turn == ForceBus::Turn::fresh;
    if (sample.connected) turns_.fetch_add(1, std::memory_order_relaxed);
    show(sample);
    if (sample.connected) continue;
    let_rest();
    bus_ = nullptr;
  }
  if (bus_) let_rest();
}

// What is lost to us may still hear: what it was told last must not stay.
void ForceDevice::let_rest() {
  DeviceSample unused;
  for (int turn = 0; turn < kLastTurns; ++turn) bus_->exchange({}, unused);
}

}  // namespace fulcrum
