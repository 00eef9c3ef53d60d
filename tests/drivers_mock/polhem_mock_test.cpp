// A Polhem by the real hidapi: pushed with, let go, unplugged, and how long a report takes to become a force.

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <numbers>
#include <optional>
#include <set>
#include <vector>

#include "drivers/registry.h"
#include "haptics/loop/live_loop.h"
#include "tests/drivers_mock/mock_devices.h"
#include "tests/drivers_mock/mock_polhem.h"
#include "tests/haptics/scenes.h"
#include "tests/support/watched_device.h"

namespace fulcrum::test {
namespace {

TEST_F(Mock, APolhemIsPushedWithAndLetGo) {
  MockPolhem board(machine);
  for (const DeviceListing& device : list_devices("no window"))
    if (device.name == "polhem") EXPECT_TRUE(device.present) << device.reason;
  EXPECT_EQ(best_device("").name, "polhem");

  auto open = open_device("polhem", {.desc = polhem_desc(), .X_DH = Pose{}});
  ASSERT_TRUE(open) << open.error().sentence;
  const Vec3 at = open->device->read().X_DH.p;
  board.turn(1000);
  wait_for([&] { return (open->device->read().X_DH.p - at).norm() > 0.01; });
  EXPECT_TRUE(open->device->read().connected);

  DeviceCommand push;
  push.effort[0] = 1;
  wait_for([&] {
    open->device->write(push);
    return board.told().back().size() == 15 && board.current() == -1033;
  });
  wait_for([&] { return board.current() == 0; });  // nobody renews it
  board.unplug();
  wait_for([&] { return !open->device->read().connected; });
  board.plug();
  wait_for([&] { return open->device->read().connected; });
  open->device.reset();
  EXPECT_EQ(board.current(), 0);
}

// A wall to the right of the arm's middle: world's down is the device's right.
SceneDesc wall_to_the_right() {
  SceneDesc desc = floor_scene({Vec3::Zero()}, 0);
  desc.device = polhem_desc();
  desc.device.max_force = 5;
  desc.mapping.X_WD.q = Quat(Eigen::AngleAxisd(-std::numbers::pi / 2, Vec3::UnitZ()));
  return desc;
}

// A haptic loop on an emulated board, and the hand that turns its arm into the wall.
class Pressed {
public:
  Pressed(World& world, Device& device, MockPolhem& board) : loop_(world, device), board_(board) {
    loop_.start();
  }

  // Until the commands are nearly alike: the tool has come to rest, and the force is back after a stop.
  void come_to_rest() {
    while (ticks_ < back_at_) look();
    for (std::size_t since = 0; since == 0 || board_.times_told() < since + kQuiet || current_ == 0;) {
      look();
      if (const int now = board_.current(); since == 0 || std::abs(now - current_) > kAlike_mA) {
        current_ = now;
        since = board_.times_told();
      }
    }
  }

  // ms, from the report that says so to the first command that answers it; none: a busy machine let a sample
  // grow stale meanwhile, and the force was stopped.
  std::optional<double> turn(int yaw) {
    stopped_ = false;
    std::size_t n = board_.times_told();
    board_.turn(yaw);
    const auto is_answer = [&](int mA) { return std::abs(mA - current_) > kAnswer_mA; };
    while (board_.said().yaw != yaw || !is_answer(board_.current())) look();
    for (const std::int64_t then = ticks_ + kAfter; ticks_ < then;) look();  // it may have been a stop
    if (stopped_) return std::nullopt;
    const std::vector<Bytes> told = board_.told();
    while (n < told.size() && !is_answer(MockPolhem::current_in(told[n]))) ++n;
    if (n == told.size()) return std::nullopt;
    return 1e3 * std::chrono::duration<double>(board_.told_at(n) - board_.said().at).count();
  }

private:
  static constexpr std::size_t kQuiet = 40;
  static constexpr int kAlike_mA = 3, kAnswer_mA = 20;  // what a step answers is some hundreds

  static constexpr std::int64_t kAfter = 10;
  static constexpr std::int64_t kBack = 700;  // ticks, in which the force comes back

  // What the main thread does while the loop runs.
  void look() {
    for (TickEvent event; loop_.next(event); ++ticks_) {
      if (!event.record.stopped) continue;
      stopped_ = true;
      back_at_ = ticks_ + kBack;
    }
    if (loop_.newest().stopped) loop_.send({Command::Kind::acknowledge});
    std::this_thread::yield();
  }

  LiveLoop loop_;
  MockPolhem& board_;
  int current_ = 0;  // mA
  std::int64_t ticks_ = 0, back_at_ = kBack;
  bool stopped_ = false;
};

// From the moment at which a report with a new pose is on the bus to the first command on the bus that
// answers it. How long that takes is said; that it comes is what is tested, and that the haptic thread asked
// the system for nothing meanwhile.
TEST_F(Mock, AReportBecomesAForce) {
  constexpr int kSteps = 100, kShallow = -200, kDeep = -400;
  MockPolhem board(machine);
  const SceneDesc desc = wall_to_the_right();
  auto open = open_device("polhem", {.desc = desc.device, .X_DH = Pose{}});
  ASSERT_TRUE(open) << open.error().sentence;
  SystemCalls calls;
  WatchedDevice device(std::move(open->device), calls);
  World world = expect(World::build(desc));
  std::vector<double> ticks;
  std::set<int> seen;
  {
    Pressed hand(world, device, board);
    board.turn(kShallow);  // into the wall, without which nothing presses on the motor
    for (int step = 0; step < kSteps; ++step) {
      hand.come_to_rest();
      if (const std::optional<double> ms = hand.turn(step % 2 == 0 ? kDeep : kShallow)) ticks.push_back(*ms);
    }
    seen = calls.seen();
  }
  if (!device.refused()) EXPECT_TRUE(seen.empty()) << "call number " << *seen.begin();
  if (ticks.empty()) GTEST_SKIP() << "this machine is too busy: each step met a stop";
  std::ranges::sort(ticks);
  EXPECT_GT(ticks.front(), 0);
  std::printf(
      "From a report on the bus to the force on the bus, of %zu: median %.2f, p99 %.2f ticks of 1 ms.\n",
      ticks.size(), ticks[ticks.size() / 2], ticks[ticks.size() * 99 / 100]);
}

}  // namespace
}  // namespace fulcrum::test
