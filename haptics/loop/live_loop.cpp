#include "haptics/loop/live_loop.h"

#include <algorithm>
#include <bit>
#include <cerrno>
#include <cmath>
#include <ctime>

#include "haptics/loop/age_clock.h"
#include "haptics/loop/real_time.h"
#include "haptics/loop/run_tick.h"

namespace fulcrum {
namespace {

constexpr std::int64_t kSecond = 1'000'000'000;
constexpr double kRingSeconds = 8;  // of ticks that the main thread may leave waiting

// When the pose was measured that a tick reads at now_ns; a sample says how old it is.
std::int64_t measured_ns(std::int64_t now_ns, double age_s) noexcept {
  constexpr double kOldest = 1000;  // s: older than any that is used, and a number of ns that is one
  const double age = age_s > 0 ? std::min(age_s, kOldest) : 0;
  return now_ns - static_cast<std::int64_t>(age * 1e9);
}

void sleep_until(std::int64_t deadline_ns) noexcept {
  const timespec until{static_cast<time_t>(deadline_ns / kSecond), static_cast<long>(deadline_ns % kSecond)};
  while (clock_nanosleep(AgeClock::kId, TIMER_ABSTIME, &until, nullptr) == EINTR) {
  }
}

}  // namespace

LiveLoop::LiveLoop(World& world, Device& device)
    : world_(world),
      device_(device),
      events_(static_cast<std::size_t>(std::ceil(kRingSeconds / world.desc().tick_s))) {}

LiveLoop::~LiveLoop() {
  stop();
}

void LiveLoop::start() {
  running_ = true;
  thread_ = std::thread([this] { run(); });
}

void LiveLoop::stop() {
  running_ = false;
  if (thread_.joinable()) thread_.join();
}

void LiveLoop::expect_word_within(double limit) {
  word_due_ns_.store(AgeClock::now_ns() + std::llround(limit * 1e9), std::memory_order_relaxed);
}

bool LiveLoop::misses_word(std::int64_t now_ns) noexcept {
  std::int64_t due = word_due_ns_.load(std::memory_order_relaxed);
  return due > 0 && now_ns >= due &&
         word_due_ns_.compare_exchange_strong(due, kWordMissed, std::memory_order_relaxed);
}

// Each turn: sleep to the deadline, see how many ticks are due, run at most kCatchUp of them with the newest
// sample.
void LiveLoop::run() {
  grant_ = {ask_for_scheduling(kHapticPriority), ask_for_locked_memory()};
  const double tick_s = world_.desc().tick_s;
  const auto tick_ns = static_cast<std::int64_t>(std::llround(tick_s * 1e9));
  std::int64_t deadline = AgeClock::now_ns() + tick_ns;
  while (running_.load(std::memory_order_relaxed)) {
    sleep_until(deadline);
    const Wake wake = wake_at(AgeClock::now_ns(), deadline, tick_ns);
    const std::int64_t due = wake.due, lost = wake.lost;
    if (lost > 0) {
      lost_.fetch_add(static_cast<std::uint64_t>(lost), std::memory_order_relaxed);
      device_.miss(static_cast<int>(std::min<std::int64_t>(lost, 1000)));
    }
    for (std::int64_t n = lost; n < due; ++n) {
      std::array<Command, kMaxCommandsPerTick> commands;
      std::size_t count = 0;
      if (n == lost && wake.long_stall) commands[count++] = {Command::Kind::watchdog};
      if (n == lost && due > 1)
        commands[count++] = {Command::Kind::caught_up, static_cast<double>(due - lost)};
      if (misses_word(deadline)) commands[count++] = {Command::Kind::unanswered};
      while (count < commands.size() && commands_.pop(commands[count])) ++count;
      TickEvent event;
      const std::int64_t began_ns = AgeClock::now_ns();
      run_tick(world_, device_, {commands.data(), count}, event);
      event.lost_before = n == lost ? lost : 0;
      event.wake_late_ns = wake.late_ns - n * tick_ns;
      const auto late_us = static_cast<std::uint64_t>(event.wake_late_ns) / 1000;
      ++histogram_[std::min<std::size_t>(std::bit_width(late_us), histogram_.size() - 1)];
      if (event.wake_late_ns >= tick_ns) late_.fetch_add(1, std::memory_order_relaxed);
      if (!events_.push(event)) unrecorded_.fetch_add(1, std::memory_order_relaxed);
      TimedTick& timed = snapshot_.draft();
      timed.record = event.record;
      timed.at_ns = AgeClock::now_ns();
      timed.sampled_ns = measured_ns(began_ns, event.sample.age);
      if (told_ != nullptr) told_->push(timed);
      snapshot_.publish();
    }
    deadline += due * tick_ns;
  }
}

}  // namespace fulcrum
