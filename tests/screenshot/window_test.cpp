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
  ASSERT_TRUE(window) << window.error().sentence;
  (*window)->show();
  auto instance = vulkan::Instance::create({true, (*window)->instance_extensions()});
  ASSERT_TRUE(instance) << instance.error().sentence;
  {
    auto surface = (*window)->surface(*instance);
    ASSERT_TRUE(surface) << surface.error().sentence;
    auto device = vulkan::Device::create(*instance, "", surface->get());
    ASSERT_TRUE(device) << device.error().sentence;
    auto swapchain = vulkan::Swapchain::create(**device, surface->get());
    ASSERT_TRUE(swapchain) << swapchain.error().sentence;
    const render::VisualDesc desc = test::make_scene();
    auto renderer = render::Renderer::create(**device, desc, {{320, 180}, {1, 256, 1.0F}, {}});
    ASSERT_TRUE(renderer) << renderer.error().sentence;
    auto overlay = Overlay::create(**device);
    ASSERT_TRUE(overlay) << overlay.error().sentence;

    render::FrameState state;
    state.X_WM = {&desc.instances[2].X_WM, 1};
    state.camera = desc.camera;
    state.overlay = overlay->get();
    const auto frame = [&](render::Extent size) {
      (*window)->poll();
      EXPECT_FALSE((*overlay)->prepare({}, size));
      const vulkan::Result<bool> shown = (*renderer)->frame(state, **swapchain, size);
      EXPECT_TRUE(shown) << (shown ? "" : shown.error().sentence);
      return *shown;
    };
    EXPECT_TRUE(frame((*window)->pixels()));
    EXPECT_TRUE(frame((*window)->pixels()));
    EXPECT_FALSE(frame({0, 0}));     // minimised
    EXPECT_TRUE(frame({200, 200}));  // a size that the window no longer has: enlarged to fit
    EXPECT_TRUE(frame({320, 180}));
    // A place that was waited for is shown in, whatever came in between; and it may be left.
    const auto wait = [&](std::uint32_t width, std::uint32_t height) {
      return (*swapchain)->wait({width, height});
    };
    EXPECT_TRUE(wait(320, 180));
    EXPECT_TRUE(wait(320, 180));
    EXPECT_FALSE(wait(0, 0));
    EXPECT_TRUE(frame({200, 200}));
    EXPECT_TRUE(wait(200, 200));
    EXPECT_TRUE(frame({320, 180}));
    EXPECT_TRUE(wait(320, 180));
    EXPECT_EQ((*renderer)->read_back()->width, 320U);
    EXPECT_FALSE((*window)->closing());
  }
  for (const std::string& message : instance->messages()) ADD_FAILURE() << message;
}

TEST(Window, WithoutADisplayTheSentenceSaysSo) {
  unsetenv("DISPLAY");
  unsetenv("WAYLAND_DISPLAY");
  const auto window = Window::create("Fulcrum", {640, 360});
  ASSERT_FALSE(window);
  EXPECT_NE(window.error().sentence.find("no display"), std::string::npos) << window.error().sentence;
}

}  // namespace
}  // namespace fulcrum::ui
