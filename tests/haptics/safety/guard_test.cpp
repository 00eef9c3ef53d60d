// A stop and what acknowledges it.

#include "haptics/safety/guard.h"

#include <gtest/gtest.h>

namespace fulcrum::test {
namespace {

constexpr double kTick = 1e-3;
const Command kAcknowledge{Command::Kind::acknowledge};

class Held {
public:
  // later: faults that are found after the commands have been read.
  double tick(std::span<const Command> commands, std::uint32_t later = 0) {
    std::uint32_t faults = guard_.watch({}, commands);
    if (later != 0) guard_.stop(later);
    const Wrench F = guard_.limit({Vec3(0, 2, 0), Vec3::Zero()}, faults);
    guard_.commanded(F);
    return F.force.norm();
  }
  bool stopped() const { return guard_.stopped(); }

private:
  Guard guard_{DeviceDesc{}, kTick, {}};
};

// Somebody leans on the key while the cause is still there: the force is gone after 2 ms, and stays away.
TEST(Guard, AcknowledgementsDoNotKeepAForceThatFalls) {
  Held held;
  for (int i = 0; i < 600; ++i) held.tick({});
  EXPECT_EQ(held.tick({&kAcknowledge, 1}, kNotFinite), 1.0);
  for (int i = 0; i < 20; ++i) EXPECT_EQ(held.tick({&kAcknowledge, 1}, kNotFinite), 0.0) << i;
}

// One that comes while the force falls is not lost.
TEST(Guard, AnAcknowledgementWaitsForTheFall) {
  Held held;
  for (int i = 0; i < 600; ++i) held.tick({});
  held.tick({}, kNotFinite);
  EXPECT_EQ(held.tick({&kAcknowledge, 1}), 0.0);
  EXPECT_TRUE(held.stopped());
  const double first = held.tick({});
  EXPECT_FALSE(held.stopped());
  EXPECT_GT(first, 0);
  EXPECT_LE(first, 2 * kTick / kRampIn * (1 + 1e-12));
}

// A fault that comes in between takes it back.
TEST(Guard, AFaultDuringTheFallTakesTheAcknowledgementBack) {
  Held held;
  for (int i = 0; i < 600; ++i) held.tick({});
  held.tick({}, kNotFinite);
  held.tick({&kAcknowledge, 1});
  const Command stop{Command::Kind::stop};
  held.tick({&stop, 1});
  for (int i = 0; i < 10; ++i) EXPECT_EQ(held.tick({}), 0.0);
  EXPECT_TRUE(held.stopped());
}

}  // namespace
}  // namespace fulcrum::test
