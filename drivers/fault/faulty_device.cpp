#include "drivers/fault/faulty_device.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <limits>
#include <thread>
#include <utility>

#include "haptics/device/hand.h"

namespace fulcrum {
namespace {

// How long each fault lasts, and what it does, in s.
constexpr double kForGood = std::numeric_limits<double>::infinity();
constexpr double kGone = 0.5, kSilent = 0.5, kCutShort = 0.01, kFrozen = 4.0, kDelay = 15e-3, kDelayed = 0.5,
                 kDeaf = 0.5, kBlind = 1.0, kLateFor = 0.5, kLateBy = 5e-3, kLateEvery = 20e-3, kPause = 0.3;
constexpr std::int64_t kSpoilt = 5;  // samples of nonsense
constexpr double kOff = 0.05;        // m
constexpr double kReach = 10;        // m, how far off nonsense lies

void stand_still(double seconds) {
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

// 0 to 1, the same in every run.
double uniform(std::uint64_t& state) {
  state = state * 6364136223846793005u + 1442695040888963407u;
  return static_cast<double>(state >> 11) * 0x1p-53;
}

}  // namespace

FaultyDevice::FaultyDevice(std::unique_ptr<Device> device, const InjectedFault& fault, double tick_s)
    : device_(std::move(device)),
      kind_(fault.kind),
      tick_s_(tick_s),
      since_(-std::llround(std::min(fault.at / tick_s, 1e15)) - 1),
      earlier_(kind_ == Injection::late_reply ? static_cast<std::size_t>(ticks(kDelay)) : 0) {}

std::int64_t FaultyDevice::ticks(double seconds) const {
  return std::isfinite(seconds) ? std::max<std::int64_t>(std::llround(seconds / tick_s_), 1)
                                : std::numeric_limits<std::int64_t>::max();
}

DeviceSample FaultyDevice::read() noexcept {
  ++since_;
  const DeviceSample now = device_->read();
  if (!begun_) std::ranges::fill(earlier_, now);
  if (since_ < 0 || !begun_) before_ = now;
  begun_ = true;
  DeviceSample shown = spoilt(now);
  if (!earlier_.empty()) {
    if (lasts(kDelayed)) {
      shown = earlier_[at_];
      shown.age += static_cast<double>(earlier_.size()) * tick_s_;
    }
    earlier_[at_] = now;
    at_ = (at_ + 1) % earlier_.size();
  }
  return shown;
}

DeviceSample FaultyDevice::spoilt(const DeviceSample& now) noexcept {
  DeviceSample sample = now;
  switch (kind_) {
    case Injection::unplug:
    case Injection::replug:
      if (!lasts(kind_ == Injection::unplug ? kForGood : kGone)) return now;
      sample = held();
      sample.connected = false;
      return sample;
    case Injection::stall:
      return lasts(kSilent) ? held() : now;
    case Injection::short_read:
      return lasts(kCutShort) ? held() : now;
    case Injection::garbage:
      return since_ >= 0 && since_ < kSpoilt ? nonsense(now) : now;
    case Injection::nan:
      if (since_ == 0) sample.X_DH.p.y() = std::numeric_limits<double>::quiet_NaN();
      return sample;
    case Injection::frozen:
      if (lasts(kFrozen)) sample.X_DH = before_.X_DH;
      return sample;
    case Injection::jump:
      if (since_ >= 0) sample.X_DH.p.x() += kOff;
      return sample;
    case Injection::write_fail:
      sample.connected = now.connected && !lasts(kDeaf);
      return sample;
    case Injection::sensor_drop:
      if (!lasts(kBlind)) return now;
      if (std::isnan(now.strip_ohm))
        sample.X_DH.q = before_.X_DH.q;
      else
        sample.strip_ohm = kStripOpen;
      return sample;
    case Injection::late:
      if (lasts(kLateFor) && since_ % ticks(kLateEvery) == 0) stand_still(kLateBy);
      return now;
    case Injection::pause:
      if (since_ == 0) stand_still(kPause);
      return now;
    case Injection::late_reply:
    case Injection::disk_full:
    case Injection::kill:
    case Injection::gpu_lost:
      break;
  }
  return now;
}

DeviceSample FaultyDevice::held() const noexcept {
  DeviceSample sample = before_;
  sample.age += static_cast<double>(since_ + 1) * tick_s_;
  return sample;
}

DeviceSample FaultyDevice::nonsense(DeviceSample sample) noexcept {
  const auto any = [this] { return 2 * uniform(noise_) - 1; };
  for (int i = 0; i < 3; ++i) sample.X_DH.p[i] = kReach * any();
  const double w = any(), x = any(), y = any(), z = any();
  sample.X_DH.q = Quat(w, x, y, z).normalized();
  // All but the stop and go of a simulated hand, which would end what is tried.
  sample.buttons = static_cast<std::uint32_t>(noise_ >> 32) & ~(kHandStopButton | kHandGoButton);
  return sample;
}

// What no command reaches lets the last one go, as firmware does.
void FaultyDevice::write(const DeviceCommand& command) noexcept {
  const bool deaf = (kind_ == Injection::unplug && lasts(kForGood)) ||
                    (kind_ == Injection::replug && lasts(kGone)) ||
                    (kind_ == Injection::write_fail && lasts(kDeaf));
  if (!deaf) {
    heard_ = command;
    device_->write(command);
    return;
  }
  device_->write(held_command(heard_, static_cast<double>(since_ + 1) * tick_s_));
}

void FaultyDevice::miss(int ticks) noexcept {
  since_ += ticks;
  device_->miss(ticks);
}

}  // namespace fulcrum
