// The haptic thread with devices whose buses come and go: it sleeps until its next tick, and asks the system
// for nothing else. So nothing can hold it up but the processor.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <thread>

#include "drivers/dualsense/dualsense_protocol.h"
#include "drivers/force/force_device.h"
#include "drivers/hid/hid_link.h"
#include "drivers/mouse/mouse_device.h"
#include "drivers/rate/rate_device.h"
#include "drivers/sound/sound_link.h"
#include "drivers/spacemouse/spacemouse_protocol.h"
#include "drivers/vibrating/rumbling_pad.h"
#include "drivers/vibrating/vibrating_device.h"
#include "haptics/loop/live_loop.h"
#include "tests/drivers/sound_card.h"
#include "tests/haptics/scenes.h"
#include "tests/support/watched_device.h"

namespace fulcrum::test {
namespace {

constexpr std::int64_t kTicks = 300;  // of a loop that is watched

// The calls of a haptic thread with this device; none: they cannot be watched here.
std::optional<std::set<int>> calls_with(std::unique_ptr<Device> device) {
  SceneDesc desc = floor_scene({Vec3::Zero()}, 0.001);
  desc.mapping.engages_at_start = true;
  World world = expect(World::build(desc));
  SystemCalls calls;
  WatchedDevice watched(std::move(device), calls);
  std::set<int> seen;
  {
    LiveLoop loop(world, watched);
    loop.start();
    for (std::int64_t ticks = 0; ticks < kTicks; std::this_thread::yield())
      for (TickEvent event; loop.next(event);) ++ticks;
    seen = calls.seen();  // its end is not a tick
    loop.stop();
  }
  if (watched.refused()) return std::nullopt;
  return seen;
}

// Presses and lets go, in its own time; every third turn nothing comes, and now and then it is away.
class Pressing final : public ForceBus {
public:
  Turn exchange(const DeviceCommand&, DeviceSample& sample) override {
    std::this_thread::sleep_for(std::chrono::microseconds(300));
    ++turn_;
    if (turn_ % 100 == 99) return Turn::lost;
    if (turn_ % 3 == 2) return Turn::none;
    sample.X_DH.p.y() = turn_ % 20 < 10 ? -0.003 : 0;
    return Turn::fresh;
  }

private:
  int turn_ = 0;
};

// Says the same again and again, takes what it is told, and is away now and then.
class Saying final : public hid::HidPort {
public:
  explicit Saying(std::vector<std::uint8_t> report) : report_(std::move(report)) {}
  int read(std::span<std::uint8_t> bytes, int) override {
    std::this_thread::sleep_for(std::chrono::microseconds(500));
    if (++count_ % 100 == 0) return -1;
    std::ranges::copy(report_, bytes.begin());
    return static_cast<int>(report_.size());
  }
  bool write(std::span<const std::uint8_t>) override { return true; }
  int read_feature(std::span<std::uint8_t>) override { return -1; }

private:
  std::vector<std::uint8_t> report_;
  int count_ = 0;
};

std::shared_ptr<hid::HidLink> linked_to(const std::function<hid::HidOpened()>& open) {
  return std::make_shared<hid::HidLink>(open(), open);
}

std::unique_ptr<Device> a_force_device() {
  const auto open = []() -> std::unique_ptr<ForceBus> { return std::make_unique<Pressing>(); };
  return expect(ForceDevice::start(DeviceDesc{}, open(), open));
}

std::unique_ptr<Device> a_cap() {
  const auto open = [] {
    return hid::HidOpened{std::make_unique<Saying>(std::vector<std::uint8_t>{1, 0x5E, 1, 0, 0, 0, 0}),
                          std::make_unique<SpaceMouseProtocol>()};
  };
  return std::make_unique<RateDevice>(MouseDevice::mouse_desc(), linked_to(open), Pose{}, 1e-3);
}

std::unique_ptr<Device> a_cap_and_a_pad() {
  std::vector<std::uint8_t> middle(64);
  middle[0] = 1;
  const auto open = [middle] {
    return hid::HidOpened{std::make_unique<Saying>(middle),
                          std::make_unique<dualsense::DualSenseProtocol>(sony::Link::usb)};
  };
  DeviceDesc desc = MouseDevice::mouse_desc();
  desc.vibrotactile = {{{.name = "left", .kind = ChannelKind::rumble, .largest = 20, .lag = 0.04},
                        {.name = "right", .kind = ChannelKind::rumble, .largest = 20, .lag = 0.02}}};
  return std::make_unique<VibratingDevice>(
      std::make_unique<MouseDevice>(desc, Pose{}, 1e-3),
      std::make_unique<RumblingPad>(linked_to(open), *desc.vibrotactile, VibrotactileSignal{.largest = 20},
                                    1e-3));
}

std::unique_ptr<Device> voice_coils() {
  static SoundCard card;
  DeviceDesc desc = MouseDevice::mouse_desc();
  const ChannelDesc left{.name = "left", .largest = 10, .resonance_Hz = 233, .quality = 3};
  desc.vibrotactile = {{left, left}};
  const auto open = [] { return std::make_unique<SoundCardPcm>(card); };
  return std::make_unique<VibratingDevice>(
      std::make_unique<MouseDevice>(desc, Pose{}, 1e-3),
      std::make_unique<sound::SoundLink>(open(), open, *desc.vibrotactile, VibrotactileSignal{.largest = 10},
                                         1e-3));
}

// The thread sanitizer's own locks call the kernel wherever one thread meets another.
#if defined(__has_feature)
#if __has_feature(thread_sanitizer)
#define FULCRUM_THREAD_SANITIZER
#endif
#endif

TEST(HapticThread, AsksTheSystemForNothing) {
#ifdef FULCRUM_THREAD_SANITIZER
  GTEST_SKIP() << "the thread sanitizer calls the system itself";
#endif
  const std::pair<const char*, std::unique_ptr<Device> (*)()> all[] = {{"a force device", &a_force_device},
                                                                       {"a cap", &a_cap},
                                                                       {"a cap and a pad", &a_cap_and_a_pad},
                                                                       {"voice coils", &voice_coils}};
  for (const auto& [name, make] : all) {
    const std::optional<std::set<int>> calls = calls_with(make());
    if (!calls) GTEST_SKIP() << "this system does not let a thread's calls be watched (seccomp)";
    EXPECT_TRUE(calls->empty()) << name << " makes call number " << *calls->begin();
  }
}

// What is asked of the system is seen.
class Asking final : public Device {
public:
  const DeviceDesc& desc() const override { return desc_; }
  DeviceSample read() noexcept override {
    std::this_thread::yield();
    return {};
  }
  void write(const DeviceCommand&) noexcept override { ::write(-1, "", 0); }
  void miss(int) noexcept override {}

private:
  DeviceDesc desc_;
};

TEST(HapticThread, WhatItAsksTheSystemForIsSeen) {
  const std::optional<std::set<int>> calls = calls_with(std::make_unique<Asking>());
  if (!calls) GTEST_SKIP() << "this system does not let a thread's calls be watched (seccomp)";
  const std::set<int> asked{SYS_write, SYS_sched_yield};
#ifdef FULCRUM_THREAD_SANITIZER
  EXPECT_TRUE(std::ranges::includes(*calls, asked));
#else
  EXPECT_EQ(*calls, asked);
#endif
}

}  // namespace
}  // namespace fulcrum::test
