// The haptic thread against its owner. Nothing here depends on how fast the machine is, only on what must
// arrive.

#include "haptics/loop/live_loop.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <limits>
#include <vector>

#include "haptics/device/simulated_device.h"
#include "haptics/loop/age_clock.h"
#include "tests/haptics/scenes.h"

namespace fulcrum::test {
namespace {

// Takes events until `done` says so; fails after a minute.
template <class Done>
void drain(LiveLoop& loop, Done&& done) {
  const auto deadline = std::chrono::steady_clock::now() + std::chrono::minutes(1);
  TickEvent event;
  while (std::chrono::steady_clock::now() < deadline) {
    while (loop.next(event))
      if (done(event)) return;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  FAIL() << "the loop did not get there in a minute";
}

TEST(LiveLoop, TicksArriveInOrderAndCommandsAct) {
  SceneDesc desc = floor_scene({Vec3::Zero()}, 0.02);
  World world = expect(World::build(desc));
  SimulatedDeviceDesc device_desc;
  device_desc.device = desc.device;
  SimulatedDevice device(device_desc, Pose{Quat::Identity(), Vec3(0, 0.02, 0)});
  LiveLoop loop(world, device);
  loop.start();
  std::int64_t next = 0, lost = 0;
  const auto in_order = [&](const TickEvent& event) {
    EXPECT_EQ(event.record.tick, next++);
    lost += event.lost_before;
  };
  drain(loop, [&](const TickEvent& event) {
    in_order(event);
    return event.record.tick == 100;
  });
  ASSERT_TRUE(loop.send({Command::Kind::stop}));
  drain(loop, [&](const TickEvent& event) {
    in_order(event);
    return event.record.stopped;
  });
  ASSERT_TRUE(loop.send({Command::Kind::acknowledge}));
  drain(loop, [&](const TickEvent& event) {
    in_order(event);
    return !event.record.stopped;
  });
  EXPECT_GE(loop.newest().tick, 100);
  loop.stop();
  TickEvent event;
  while (loop.next(event)) in_order(event);
  EXPECT_EQ(loop.unrecorded(), 0u);
  EXPECT_EQ(loop.lost_ticks(), static_cast<std::uint64_t>(lost));
}

// The second listener hears every tick as the first does; and where nobody takes them, the loop goes on.
TEST(LiveLoop, TellsOneMoreThreadOfEveryTick) {
  SceneDesc desc = floor_scene({Vec3::Zero()}, 0.02);
  World world = expect(World::build(desc));
  SimulatedDeviceDesc device_desc;
  device_desc.device = desc.device;
  SimulatedDevice device(device_desc, Pose{Quat::Identity(), Vec3(0, 0.02, 0)});
  LiveLoop loop(world, device);
  TimedTicks told(200);
  loop.also_tell(told);
  const std::int64_t before = AgeClock::now_ns();
  loop.start();
  std::vector<TickRecord> seen;
  drain(loop, [&](const TickEvent& event) {
    seen.push_back(event.record);
    return event.record.tick == 400;
  });
  loop.stop();
  EXPECT_EQ(loop.unrecorded(), 0u);
  std::int64_t last_ns = before;
  TimedTick tick;
  for (std::size_t i = 0; i < 200; ++i) {
    ASSERT_TRUE(told.pop(tick)) << i;
    EXPECT_EQ(tick.record.tick, seen[i].tick);
    EXPECT_EQ(tick.record.X_WT.p, seen[i].X_WT.p);
    EXPECT_GT(tick.at_ns, last_ns);
    EXPECT_LT(tick.sampled_ns, tick.at_ns);
    EXPECT_GE(tick.sampled_ns, last_ns);  // this device measures as it is read
    last_ns = tick.at_ns;
  }
  EXPECT_FALSE(told.pop(tick));  // what found no place was left out
}

// A device whose samples say that they are old.
class OldDevice final : public Device {
public:
  OldDevice(const SimulatedDeviceDesc& desc, const Pose& X_DH, double age) : device_(desc, X_DH), age_(age) {}
  const DeviceDesc& desc() const override { return device_.desc(); }
  DeviceSample read() noexcept override {
    DeviceSample sample = device_.read();
    sample.age = age_;
    return sample;
  }
  void write(const DeviceCommand& command) noexcept override { device_.write(command); }
  void miss(int ticks) noexcept override { device_.miss(ticks); }

private:
  SimulatedDevice device_;
  double age_;
};

TEST(LiveLoop, ASampleIsAsOldAsItSays) {
  SceneDesc desc = floor_scene({Vec3::Zero()}, 0.02);
  SimulatedDeviceDesc device_desc;
  device_desc.device = desc.device;
  struct Case {
    double age, least, most;  // s
  };
  const double infinite = std::numeric_limits<double>::infinity();
  for (const Case& of :
       {Case{0.004, 0.004, 60}, Case{-5, 0, 60}, Case{std::nan(""), 0, 60}, Case{infinite, 1000, 1060}}) {
    World world = expect(World::build(desc));
    OldDevice device(device_desc, Pose{Quat::Identity(), Vec3(0, 0.02, 0)}, of.age);
    LiveLoop loop(world, device);
    EXPECT_EQ(loop.newest_timed().sampled_ns, 0);  // before the first tick
    loop.start();
    drain(loop, [&](const TickEvent& event) { return event.record.tick == 5; });
    loop.stop();
    const TimedTick& tick = loop.newest_timed();
    EXPECT_EQ(tick.record.tick, loop.newest().tick);
    EXPECT_GE(tick.at_ns - tick.sampled_ns, static_cast<std::int64_t>(1e9 * of.least)) << of.age;
    EXPECT_LE(tick.at_ns - tick.sampled_ns, static_cast<std::int64_t>(1e9 * of.most)) << of.age;
  }
}

// A main thread that does not come back: the force is stopped once, and whoever comes back is told so.
TEST(LiveLoop, AWordThatDoesNotComeStopsTheForce) {
  SceneDesc desc = floor_scene({Vec3::Zero()}, 0.02);
  World world = expect(World::build(desc));
  SimulatedDeviceDesc device_desc;
  device_desc.device = desc.device;
  SimulatedDevice device(device_desc, Pose{Quat::Identity(), Vec3(0, 0.02, 0)});
  LiveLoop loop(world, device);
  EXPECT_TRUE(loop.gives_word());  // none was expected
  loop.expect_word_within(3600);
  loop.start();
  drain(loop, [&](const TickEvent& event) {
    for (const Command& command : event.commands()) EXPECT_NE(command.kind, Command::Kind::unanswered);
    return event.record.tick == 50;
  });
  EXPECT_TRUE(loop.gives_word());
  loop.expect_word_within(0.05);
  int commands = 0;
  drain(loop, [&](const TickEvent& event) {
    for (const Command& command : event.commands())
      commands += command.kind == Command::Kind::unanswered ? 1 : 0;
    if (event.record.stopped) EXPECT_EQ(event.record.faults & kStoppingFaults, kUnanswered);
    return event.record.stopped;
  });
  EXPECT_FALSE(loop.gives_word());
  EXPECT_TRUE(loop.gives_word());  // that is said once
  ASSERT_TRUE(loop.send({Command::Kind::acknowledge}));
  std::int64_t back = -1;
  drain(loop, [&](const TickEvent& event) {
    for (const Command& command : event.commands())
      commands += command.kind == Command::Kind::unanswered ? 1 : 0;
    if (back < 0 && !event.record.stopped) back = event.record.tick;
    return back >= 0 && event.record.tick == back + 50;
  });
  loop.stop();
  EXPECT_EQ(commands, 1);
}

// A device whose driver hangs once for a while.
class HangingDevice final : public Device {
public:
  HangingDevice(const SimulatedDeviceDesc& desc, const Pose& X_DH) : device_(desc, X_DH) {}
  const DeviceDesc& desc() const override { return device_.desc(); }
  void write(const DeviceCommand& command) noexcept override { device_.write(command); }
  DeviceSample read() noexcept override {
    if (reads_++ == 50) std::this_thread::sleep_for(hang);
    return device_.read();
  }
  void miss(int ticks) noexcept override {
    if (reads_ > 50) missed += ticks;
    device_.miss(ticks);
  }
  std::chrono::milliseconds hang{0};
  int missed = 0;

private:
  SimulatedDevice device_;
  int reads_ = 0;
};

// Of a gap of n ticks at most 5 are run, the rest are lost, counted in their place and told to the device;
// past a quarter of a second the force stops.
TEST(LiveLoop, AGapIsLostTicksAndALongOneStopsTheForce) {
  for (const int gap_ms : {100, 400}) {
    const SceneDesc desc = floor_scene({Vec3::Zero()}, 0.02);
    World world = expect(World::build(desc));
    SimulatedDeviceDesc device_desc;
    device_desc.device = desc.device;
    HangingDevice device(device_desc, Pose{Quat::Identity(), Vec3(0, 0.02, 0)});
    device.hang = std::chrono::milliseconds(gap_ms);
    LiveLoop loop(world, device);
    loop.start();
    // The tick that hangs may be in the middle of a turn that catches up: the gap is seen in the next turn.
    std::int64_t lost_there = 0, next = 0;
    std::uint32_t faults = 0;
    bool stopped = false;
    drain(loop, [&](const TickEvent& event) {
      EXPECT_EQ(event.record.tick, next++) << "lost ticks are not numbered";
      if (event.record.tick <= 50 || event.lost_before == 0) return false;
      lost_there = event.lost_before;
      faults = event.record.faults;
      stopped = event.record.stopped;
      return true;
    });
    loop.stop();
    EXPECT_GE(lost_there, gap_ms - kCatchUp - 2) << gap_ms;
    const std::int64_t late_ticks = lost_there + kCatchUp - 1;
    EXPECT_EQ((faults & kWatchdog) != 0, late_ticks >= 250) << gap_ms << ", " << late_ticks;
    EXPECT_TRUE(stopped || late_ticks < 250) << gap_ms << ", " << late_ticks;
    EXPECT_GE(device.missed, lost_there);
    EXPECT_GE(loop.late_ticks(), 4u) << "of the five that are run, all but the last";
  }
}

}  // namespace
}  // namespace fulcrum::test
