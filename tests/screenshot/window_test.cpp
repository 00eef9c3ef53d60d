// A window is opened, drawn into and closed, under the validation layers; and the absence of a display is a
// sentence.

#include "engine/ui/window.h"

#include <gtest/gtest.h>

#include <cstdlib>

#include "engine/ui/overlay.h"
#include "test_scene.h"

namespace fulcrum::ui {
namespace {

TEST(WindowTest, IsDrawnIntoAtEverySize) {
  if (std::getenv("DISPLAY") == nullptr && std::getenv("WAYLAND_DISPLAY") == nullptr)
    GTEST_SKIP() << "There is no display here.";
  auto window = Window::create("Fulcrum test", {320, 180});
  ASSERT_TRUE(window) << window.error();
  window.value()->show();
  auto instance = vulkan::Instance::create({true, window.value()->instance_extensions()});
  ASSERT_TRUE(instance) << instance.error();
  {
    auto surface = window.value()->surface(instance.value());
    ASSERT_TRUE(surface) << surface.error();
    auto device = vulkan::Device::create(instance.value(), "", surface.value().get());
    ASSERT_TRUE(device) << device.error();
    auto swapchain = vulkan::Swapchain::create(*device.value(), surface.value().get());
    ASSERT_TRUE(swapchain) << swapchain.error();
    const render::VisualDesc desc = test::make_scene();
    auto renderer = render::Renderer::create(*device.value(), desc, {{320, 180}, {1, 256, 1.0F}, {}});
    ASSERT_TRUE(renderer) << renderer.error();
    auto overlay = Overlay::create(*device.value());
    ASSERT_TRUE(overlay) << overlay.error();

    render::FrameState state;
    state.X_WM = {&desc.instances[2].X_WM, 1};
    state.camera = desc.camera;
    state.overlay = overlay.value().get();
    const auto frame = [&](render::Extent size) {
      window.value()->poll();
      EXPECT_TRUE(overlay.value()->prepare({}, size));
      const vulkan::Result<bool> shown = renderer.value()->frame(state, *swapchain.value(), size);
      EXPECT_TRUE(shown) << (shown ? "" : shown.error());
      return shown.value();
    };
    EXPECT_TRUE(frame(window.value()->pixels()));
    EXPECT_TRUE(frame(window.value()->pixels()));
    EXPECT_FALSE(frame({0, 0}));     // minimised
    EXPECT_TRUE(frame({200, 200}));  // a size that the window no longer has: enlarged to fit
    EXPECT_TRUE(frame({320, 180}));
    EXPECT_EQ(renderer.value()->read_back().value().width, 320U);
    EXPECT_FALSE(window.value()->closing());
  }
  for (const std::string& message : instance.value().messages()) ADD_FAILURE() << message;
}

TEST(Window, WithoutADisplayTheSentenceSaysSo) {
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  const auto window = Window::create("Fulcrum", {640, 360});
  ASSERT_FALSE(window);
  EXPECT_NE(window.error().find("no display"), std::string::npos) << window.error();
}

}  // namespace
}  // namespace fulcrum::ui
