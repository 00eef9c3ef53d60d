// A machine that is suspended cannot be had in a test, but its clock can: in a time namespace of Linux's the
// clock that goes on meanwhile is ahead of the one that rests, as after an hour of suspension.

#include "haptics/loop/age_clock.h"

#include <gtest/gtest.h>
#include <sched.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cstdio>

#include "haptics/loop/wake.h"

namespace fulcrum::test {
namespace {

constexpr std::int64_t kSecond_ns = 1'000'000'000, kHour_s = 3600;
constexpr int kSkipped = 77;

bool written(const char* file, const char* text) {
  std::FILE* const open = std::fopen(file, "w");
  if (open == nullptr) return false;
  const bool good = std::fputs(text, open) >= 0;
  return std::fclose(open) == 0 && good;
}

std::int64_t rested_ns() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return now.tv_sec * kSecond_ns + now.tv_nsec;
}

// What a process makes of `seen` whose machine has been suspended for an hour longer than this one; kSkipped
// where the system grants no such clock.
template <class Seen>  // int ()
int after_an_hour(Seen seen) {
  const pid_t outer = fork();
  if (outer == 0) {
    constexpr int kTimeOfItsOwn = 0x80;  // CLONE_NEWTIME
    const bool granted = (unshare(kTimeOfItsOwn) == 0 || unshare(CLONE_NEWUSER | kTimeOfItsOwn) == 0) &&
                         written("/proc/self/timens_offsets", "boottime 3600 0\n");
    if (!granted) _exit(kSkipped);
    const pid_t inner = fork();
    if (inner == 0) _exit(seen());
    int status = 0;
    waitpid(inner, &status, 0);
    _exit(WIFEXITED(status) ? WEXITSTATUS(status) : 1);
  }
  int status = 0;
  waitpid(outer, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : 1;
}

TEST(AgeClock, GoesOnWhileTheMachineIsSuspended) {
  const std::int64_t before = AgeClock::now_ns() - rested_ns();
  const int code = after_an_hour([before] {
    const std::int64_t ahead = AgeClock::now_ns() - rested_ns() - before;
    return ahead > (kHour_s - 60) * kSecond_ns && ahead < (kHour_s + 60) * kSecond_ns ? 0 : 1;
  });
  if (code == kSkipped) GTEST_SKIP() << "this system grants no clock of one's own";
  EXPECT_EQ(code, 0);
}

TEST(AgeClock, DoesNotGoBack) {
  AgeClock::time_point before = AgeClock::now();
  for (int i = 0; i < 10000; ++i) {
    const AgeClock::time_point now = AgeClock::now();
    ASSERT_LE(before, now);
    before = now;
  }
}

TEST(Wake, InTimeOneTickIsDue) {
  for (const std::int64_t late : {-500'000L, 0L, 999'999L}) {
    const Wake wake = wake_at(10 * kSecond_ns + late, 10 * kSecond_ns, 1'000'000);
    EXPECT_EQ(wake.due, 1);
    EXPECT_EQ(wake.lost, 0);
    EXPECT_FALSE(wake.long_stall);
    EXPECT_EQ(wake.late_ns, std::max<std::int64_t>(late, 0));
  }
}

TEST(Wake, OfAGapFiveTicksAreRunAndALongOneStopsTheForce) {
  const auto after_ms = [](std::int64_t ms) { return wake_at(ms * 1'000'000, 0, 1'000'000); };
  EXPECT_EQ(after_ms(4).lost, 0);
  EXPECT_EQ(after_ms(60).due, 61);
  EXPECT_EQ(after_ms(60).lost, 56);
  EXPECT_FALSE(after_ms(249).long_stall);
  EXPECT_TRUE(after_ms(250).long_stall);
}

// Resumed after an hour: one turn, and it stops the force before anything is pushed with.
TEST(Wake, AfterASuspensionTheForceStopsAndItsTicksAreLost) {
  const Wake wake = wake_at((kHour_s + 5) * kSecond_ns, 5 * kSecond_ns, 1'000'000);
  EXPECT_TRUE(wake.long_stall);
  EXPECT_EQ(wake.due, 3'600'001);
  EXPECT_EQ(wake.due - wake.lost, kCatchUp);
}

}  // namespace
}  // namespace fulcrum::test
