#include "engine/ui/window.h"

#define GLFW_INCLUDE_VULKAN
#include <GLFW/glfw3.h>

#include <algorithm>
#include <utility>

#include "engine/ui/window_loss.h"

namespace fulcrum::ui {
namespace {

Window* window_of(GLFWwindow* window) {
  return static_cast<Window*>(glfwGetWindowUserPointer(window));
}

std::string last_error() {
  const char* description = nullptr;
  glfwGetError(&description);
  return description == nullptr ? "no reason given" : description;
}

// Empty, or why it does not start.
std::string start_glfw() {
  if (glfwInit() != GLFW_TRUE)
    return "There is no display to open a window on (" + last_error() +
           "): start Fulcrum from a desktop session with an X server, or run it with --headless.";
  if (glfwVulkanSupported() == GLFW_TRUE) return {};
  glfwTerminate();
  return "No Vulkan driver can draw into a window here: install the driver of the graphics card or "
         "mesa-vulkan-drivers, or run Fulcrum with --headless.";
}

// All monitors together, in the window's own coordinates.
ScreenArea screens_of(GLFWwindow* window) {
  ScreenArea area;
  int window_x = 0;
  int window_y = 0;
  glfwGetWindowPos(window, &window_x, &window_y);
  int count = 0;
  GLFWmonitor** monitors = glfwGetMonitors(&count);
  for (int i = 0; i < count; ++i) {
    int x = 0;
    int y = 0;
    glfwGetMonitorPos(monitors[i], &x, &y);
    const GLFWvidmode* mode = glfwGetVideoMode(monitors[i]);
    if (mode == nullptr) continue;
    area.add(x - window_x, y - window_y, mode->width, mode->height);
  }
  return area;
}

}  // namespace

std::string why_no_window() {
  std::string reason = start_glfw();
  if (reason.empty()) glfwTerminate();
  return reason;
}

vulkan::Result<std::unique_ptr<Window>> Window::create(const std::string& title, render::Extent size) {
  if (std::string reason = start_glfw(); !reason.empty()) return vulkan::Error{std::move(reason)};
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
  glfwWindowHint(GLFW_VISIBLE, GLFW_FALSE);
  GLFWwindow* window = glfwCreateWindow(static_cast<int>(size.width), static_cast<int>(size.height),
                                        title.c_str(), nullptr, nullptr);
  if (window == nullptr) {
    const std::string reason = last_error();
    glfwTerminate();
    return vulkan::Error{"The window did not open (" + reason +
                         "): try a smaller size, or run Fulcrum headless."};
  }
  return std::unique_ptr<Window>(new Window(window));
}

Window::Window(GLFWwindow* window) : window_(window) {
  watch_for_loss(window_);
  glfwSetWindowUserPointer(window_, this);
  glfwSetKeyCallback(
      window_,
      [](GLFWwindow* from, int key, int, int action, int modifiers) {
        if (const auto& handler = window_of(from)->events_.key) handler(key, action, modifiers);
      });
  glfwSetMouseButtonCallback(
      window_,
      [](GLFWwindow* from, int button, int action, int modifiers) {
        if (const auto& handler = window_of(from)->events_.button) {
          handler(button, action, modifiers);
        }
      });
  glfwSetCursorPosCallback(
      window_, [](GLFWwindow* from, double x, double y) { window_of(from)->on_cursor(x, y); });
  glfwSetCharCallback(
      window_,
      [](GLFWwindow* from, unsigned letter) {
        if (const auto& handler = window_of(from)->events_.text) handler(letter);
      });
  glfwSetScrollCallback(window_, [](GLFWwindow* from, double dx, double dy) {
    if (const auto& handler = window_of(from)->events_.scroll) {
      handler(dx, dy);
    }
  });
}

void Window::show() {
  ask_display([this] { glfwShowWindow(window_); });
}

void Window::on_cursor(double x, double y) {
  if (pointer_) pointer_->move(x, y);
  int width = 0;
  int height = 0;
  if (!ask_display([&] { glfwGetWindowSize(window_, &width, &height); })) return;
  if (events_.cursor && height > 0)
    events_.cursor((pointer_ ? pointer_->x() : x) / height, (pointer_ ? pointer_->y() : y) / height);
}

void Window::hold_pointer(bool held) {
  if (held == pointer_.has_value()) return;
  double x = 0;
  double y = 0;
  ScreenArea screens;
  const bool answered = ask_display([&] {
    glfwGetCursorPos(window_, &x, &y);
    screens = screens_of(window_);
  });
  if (!answered) return;
  pointer_.reset();
  if (held)
    pointer_.emplace(x, y, screens);
  else
    on_cursor(x, y);  // where it is seen
}

// After all that has been told: an event that is still on its way comes from either side of the jump, and
// WrappedPointer knows both.
void Window::wrap_pointer() {
  if (!pointer_) return;
  if (const auto to = pointer_->jump()) ask_display([&] { glfwSetCursorPos(window_, to->x, to->y); });
}

Window::~Window() {
  // The system takes back what a lost display leaves.
  ask_display([this] {
    glfwDestroyWindow(window_);
    glfwTerminate();
  });
}

std::vector<std::string> Window::instance_extensions() const {
  std::uint32_t count = 0;
  const char** names = glfwGetRequiredInstanceExtensions(&count);
  return {names, names + count};
}

vulkan::Result<vulkan::Surface> Window::surface(const vulkan::Instance& instance) const {
  VkSurfaceKHR made = VK_NULL_HANDLE;
  if (glfwCreateWindowSurface(instance.get(), window_, nullptr, &made) != VK_SUCCESS) {
    return vulkan::Error{"Vulkan cannot draw into this window (" + last_error() +
                         "): update the graphics driver, or run Fulcrum headless."};
  }
  return vulkan::Surface(instance.get(), made);
}

void Window::poll() {
  ask_display([] { glfwPollEvents(); });
  wrap_pointer();
}

void Window::poll_or_wait() {
  if (const render::Extent now = pixels(); now.width == 0 || now.height == 0)
    ask_display([] { glfwWaitEventsTimeout(0.1); });
  poll();
}

void Window::copy(const std::string& text) {
  ask_display([&] { glfwSetClipboardString(window_, text.c_str()); });
}

void Window::hide() {
  ask_display([&] { glfwHideWindow(window_); });
}

bool Window::closing() const {
  return lost() || glfwWindowShouldClose(window_) == GLFW_TRUE;
}

bool Window::lost() const {
  return window_lost();
}

render::Extent Window::pixels() const {
  int width = 0;
  int height = 0;
  const bool answered = ask_display([&] {
    // X11 leaves a hidden window its size.
    if (glfwGetWindowAttrib(window_, GLFW_ICONIFIED) != GLFW_TRUE)
      glfwGetFramebufferSize(window_, &width, &height);
  });
  if (!answered) return {0, 0};
  return {static_cast<std::uint32_t>(std::max(width, 0)), static_cast<std::uint32_t>(std::max(height, 0))};
}

}  // namespace fulcrum::ui
