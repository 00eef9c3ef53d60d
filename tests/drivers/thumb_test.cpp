// The template of a driver, against bytes written down here. What its thread does is ForceDevice's test.

#include <gtest/gtest.h>

#include "drivers/template/thumb_bus.h"
#include "engine/scenario/load.h"

namespace fulcrum::test {
namespace {

struct ThumbPort final : hid::HidPort {
  int read(std::span<std::uint8_t> report, int wait_ms) override {
    if (!plugged || wait_ms == 0) return plugged ? 0 : -1;
    std::ranges::copy(says, report.begin());
    return static_cast<int>(says.size());
  }
  bool write(std::span<const std::uint8_t> report) override {
    heard.assign(report.begin(), report.end());
    return plugged;
  }
  int read_feature(std::span<std::uint8_t>) override { return -1; }
  bool plugged = true;
  std::vector<std::uint8_t> says{0xE8, 0x03, 0x18, 0xFC, 0, 0, 1};  // 10 mm right, 10 mm down, a button
  std::vector<std::uint8_t> heard;
};

TEST(Thumb, IsReadPushedAndUnplugged) {
  const auto desc = scenario::load_device(FULCRUM_SOURCE_DIR "/drivers/template/thumb.yaml");
  ASSERT_TRUE(desc);
  auto* const port = new ThumbPort;
  thumb::ThumbBus bus(std::unique_ptr<hid::HidPort>(port), *desc);
  DeviceSample sample;
  DeviceCommand push;
  push.F_H_D.force = {1, 0, -0.5};
  EXPECT_EQ(bus.exchange(push, sample), ForceBus::Turn::fresh);
  EXPECT_LT((sample.X_DH.p - Vec3(0.01, -0.01, 0)).norm(), 1e-12);
  EXPECT_EQ(sample.buttons, 1u);
  EXPECT_EQ(port->heard, (std::vector<std::uint8_t>{0, 0xE8, 0x03, 0, 0, 0x0C, 0xFE}));
  push.F_H_D.force = {1, NAN, 1e9};
  port->says.pop_back();
  EXPECT_EQ(bus.exchange(push, sample), ForceBus::Turn::none) << "that is no report";
  EXPECT_EQ(port->heard, std::vector<std::uint8_t>(7)) << "and this is no force";
  port->plugged = false;
  EXPECT_EQ(bus.exchange(push, sample), ForceBus::Turn::lost);
}

}  // namespace
}  // namespace fulcrum::test
