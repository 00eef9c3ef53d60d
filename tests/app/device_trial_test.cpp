// What the start page's test of a device shows, and that it asks nothing of motors.

#include "engine/app/start/device_trial.h"

#include <GLFW/glfw3.h>
#include <gtest/gtest.h>

#include <memory>
#include <string>
#include <vector>

namespace fulcrum::app::test {
namespace {

// Looks for a while, as often as a window does.
void look(DeviceTrial& trial, std::vector<ui::PadState> pads = {}) {
  static double now = 0;
  for (int frame = 0; frame < 20; ++frame) trial.advance(now += 0.016, pads);
}

std::unique_ptr<DeviceTrial> opened(const char* name) {
  DeviceOrder order{.desc = MouseDevice::mouse_desc(), .X_DH = Pose{}};
  auto device = open_device(name, order);
  EXPECT_TRUE(device) << name;
  return std::make_unique<DeviceTrial>(name, order.desc, std::move(*device));
}

TEST(DeviceTrial, ShowsHowFarAKeyPushes) {
  const auto trial = opened("keyboard");
  look(*trial);
  EXPECT_NEAR(trial->panel().axes[0].part, 0, 1e-9);
  EXPECT_FALSE(trial->panel().axes[0].moved);
  trial->key(GLFW_KEY_RIGHT, GLFW_PRESS, false);
  trial->key(GLFW_KEY_E, GLFW_PRESS, false);
  look(*trial);
  const ui::DevicePanel panel = trial->panel();
  ASSERT_EQ(panel.axes.size(), 6U);
  EXPECT_NEAR(panel.axes[0].part, 0.6, 1e-3) << "as far as a key counts";
  EXPECT_EQ(panel.axes[0].value, "+60 %");
  EXPECT_NEAR(panel.axes[5].part, -0.6, 1e-3) << "E rolls to the right";
  EXPECT_TRUE(panel.axes[0].moved);
  EXPECT_FALSE(panel.axes[1].moved);
  trial->key(GLFW_KEY_RIGHT, GLFW_RELEASE, false);
  look(*trial);
  EXPECT_NEAR(trial->panel().axes[0].part, 0, 1e-2) << "let go";
  EXPECT_TRUE(trial->panel().axes[0].moved) << "it has";
}

TEST(DeviceTrial, ShowsAPadsSticksAndButtonsAndThatItIsGone) {
  const auto trial = opened("gamepad");
  const ui::PadState pad{.guid = "pad", .left_y = 1, .buttons = ui::kPadA | ui::kPadLeftBumper};
  look(*trial, {pad});
  EXPECT_NEAR(trial->panel().axes[1].part, 1, 1e-2);
  EXPECT_NEAR(trial->panel().axes[5].part, 1, 1e-2) << "the bumper rolls";
  EXPECT_EQ(trial->panel().buttons, "Buttons down: A, left bumper");
  EXPECT_EQ(trial->panel().trouble, "");
  look(*trial);
  EXPECT_NE(trial->panel().trouble.find("plug it in"), std::string::npos);
  EXPECT_NEAR(trial->panel().axes[1].part, 0, 1e-2);
}

TEST(DeviceTrial, ShowsHowFarTheMouseHasDragged) {
  const auto trial = opened("mouse");
  trial->drag(0.2, 0, true, false);
  trial->drag(0.1, 0, false, false);
  trial->wheel(-2, false);
  look(*trial);
  const ui::DevicePanel panel = trial->panel();
  EXPECT_EQ(panel.axes[0].value, "+40 mm");
  EXPECT_EQ(panel.axes[2].value, "+10 mm") << "turned down, the wheel brings it nearer";
  EXPECT_GT(panel.axes[4].part, 0.2) << "the right button turns";
  EXPECT_NE(panel.notes.back().find("cannot push"), std::string::npos) << panel.notes.back();
}

// A handle with motors, which counts what is asked of them.
class Arm final : public Device {
public:
  Arm() {
    desc_.senses_rotation = false;
    sample_.X_DH.p = {0.02, 0, 0};
  }
  const DeviceDesc& desc() const override { return desc_; }
  DeviceSample read() noexcept override { return sample_; }
  void write(const DeviceCommand&) noexcept override { ++writes; }
  void miss(int) noexcept override {}

  DeviceDesc desc_;
  DeviceSample sample_;
  int writes = 0;
};

TEST(DeviceTrial, ShowsAHandleInItsWorkspaceAndAsksNothingOfItsMotors) {
  auto arm = std::make_unique<Arm>();
  Arm& held = *arm;
  DeviceTrial trial("polhem", held.desc_, OpenDevice{.device = std::move(arm)});
  look(trial);
  ASSERT_EQ(trial.panel().axes.size(), 3U) << "it senses no turn";
  EXPECT_NEAR(trial.panel().axes[0].part, 0.25, 1e-9) << "of 80 mm to each side";
  EXPECT_FALSE(trial.panel().axes[0].moved) << "that is where it was found";
  held.sample_.X_DH.p = {-0.04, 0, 0};
  held.sample_.buttons = 0b101;
  look(trial);
  EXPECT_EQ(trial.panel().axes[0].value, "-40 mm");
  EXPECT_TRUE(trial.panel().axes[0].moved);
  EXPECT_EQ(trial.panel().buttons, "Buttons down: 1, 3");
  EXPECT_NE(trial.panel().notes.back().find("`fulcrum device-test polhem`"), std::string::npos);
  held.sample_.connected = false;
  look(trial);
  EXPECT_NE(trial.panel().trouble, "");
  EXPECT_EQ(held.writes, 0);
}

TEST(DeviceTrial, SaysWhyADeviceCannotBeTested) {
  const auto none = DeviceTrial::open("polhem");
  ASSERT_FALSE(none);
  EXPECT_NE(none.error().sentence.find("plugged in"), std::string::npos) << none.error().sentence;
}

}  // namespace
}  // namespace fulcrum::app::test
