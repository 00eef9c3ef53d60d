// What was recorded comes back sample by sample; what was missed is passed over; at the end the handle rests.

#include "drivers/replay/replay_device.h"

#include <gtest/gtest.h>

namespace fulcrum::test {
namespace {

std::vector<DeviceSample> recorded(int count) {
  std::vector<DeviceSample> samples(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    samples[static_cast<std::size_t>(i)].X_DH.p.x() = i;
    samples[static_cast<std::size_t>(i)].buttons = static_cast<std::uint32_t>(i % 2);
  }
  return samples;
}

TEST(ReplayDevice, GivesEachSampleOnceAndThenTheLast) {
  ReplayDevice device(DeviceDesc{}, recorded(3));
  for (const double expected : {0, 1, 2, 2, 2}) EXPECT_EQ(device.read().X_DH.p.x(), expected);
  EXPECT_TRUE(device.finished());
}

TEST(ReplayDevice, IsFinishedAfterTheLastSample) {
  ReplayDevice device(DeviceDesc{}, recorded(2));
  EXPECT_FALSE(device.finished());
  device.read();
  EXPECT_FALSE(device.finished());
  device.read();
  EXPECT_TRUE(device.finished());
}

// Ticks that are lost are lost of the motion too: it does not stretch.
TEST(ReplayDevice, MissedTicksArePassedOver) {
  ReplayDevice device(DeviceDesc{}, recorded(10));
  device.read();
  device.miss(4);
  EXPECT_EQ(device.read().X_DH.p.x(), 5);
  device.miss(100);
  EXPECT_EQ(device.read().X_DH.p.x(), 9);
  EXPECT_TRUE(device.finished());
}

TEST(ReplayDevice, StandsInForADeviceAndFeelsNothing) {
  DeviceDesc desc;
  desc.name = "w6d";
  ReplayDevice device(desc, recorded(2));
  EXPECT_EQ(device.desc().name, "w6d");
  const double before = device.read().X_DH.p.x();
  device.write({.F_H_D = {Vec3(100, 0, 0), Vec3::Zero()}});
  EXPECT_EQ(device.read().X_DH.p.x(), before + 1);
}

}  // namespace
}  // namespace fulcrum::test
