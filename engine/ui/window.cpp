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

}  // namespace

std::string why_no_window() {
  const std::string reason = start_glfw();
  if (reason.empty()) glfwTerminate();
  return reason;
}

vulkan::Result<std::unique_ptr<Window>> Window::create(const std::string& title, render::Extent size) {
  if (std::string reason = start_glfw(); !reason.empty()) return vulkan::Error{std::move(reason)};
  glfwWindowHint(GLFW_CLIENT_API, GLFW_NO_API);
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
  glfwSetKeyCallback(window_, [](GLFWwindow* from, int key, int, int action, int modifiers) {
    if (const auto& handler = window_of(from)->events_.key) {
      handler(key, action, modifiers);
    }
  });
  glfwSetMouseButtonCallback(window_, [](GLFWwindow* from, int button, int action, int modifiers) {
    if (const auto& handler = window_of(from)->events_.button) {
      handler(button, action, modifiers);
    }
  });
  glfwSetCursorPosCallback(window_, [](GLFWwindow* from, double x, double y) {
    int width = 0;
    int height = 0;
    glfwGetWindowSize(from, &width, &height);
    if (const auto& handler = window_of(from)->events_.cursor; handler && height > 0) {
      handler(x / height, y / height);
    }
  });
  glfwSetScrollCallback(window_, [](GLFWwindow* from, double dx, double dy) {
    if (const auto& handler = window_of(from)->events_.scroll) {
      handler(dx, dy);
    }
  });
}

Window::~Window() {
  glfwDestroyWindow(window_);
  glfwTerminate();
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
  if (lost()) return;
  const render::Extent now = pixels();
  if (now.width == 0 || now.height == 0 || glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE) {
    glfwWaitEventsTimeout(0.1);
  } else {
    glfwPollEvents();
  }
}

bool Window::closing() const {
  return lost() || glfwWindowShouldClose(window_) == GLFW_TRUE;
}

bool Window::lost() const {
  return window_lost();
}

render::Extent Window::pixels() const {
  if (lost()) return {0, 0};
  if (glfwGetWindowAttrib(window_, GLFW_ICONIFIED) == GLFW_TRUE) {
    return {0, 0};  // X11 leaves a hidden window its size
  }
  int width = 0;
  int height = 0;
  glfwGetFramebufferSize(window_, &width, &height);
  if (lost()) return {0, 0};  // noticed only now, and the size is no number
  return {static_cast<std::uint32_t>(std::max(width, 0)), static_cast<std::uint32_t>(std::max(height, 0))};
}

}  // namespace fulcrum::ui
