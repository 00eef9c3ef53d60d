#pragma once
// A window: its events, its size, its surface. One window at a time, from the main thread.

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/render/plan.h"
#include "engine/ui/wrapped_pointer.h"
#include "engine/vulkan/swapchain.h"

struct GLFWwindow;

namespace fulcrum::ui {

// Raw events, with GLFW's numbers for keys, buttons, actions and modifiers. Any may be empty.
struct WindowEvents {
  std::function<void(int key, int action, int modifiers)> key;
  std::function<void(int button, int action, int modifiers)> button;
  // Fractions of the window's height, from its top left.
  std::function<void(double x, double y)> cursor;
  std::function<void(double dx, double dy)> scroll;  // wheel steps
  std::function<void(char32_t letter)> text;         // as the keyboard's layout has it
};

// Why no window can be opened here, and what would change that; empty where one can.
std::string why_no_window();

class Window {
public:
  // Hidden until show(). Fails with a sentence where there is no display. `size` in screen units.
  static vulkan::Result<std::unique_ptr<Window>> create(const std::string& title, render::Extent size);
  ~Window();
  Window(const Window&) = delete;
  Window& operator=(const Window&) = delete;

  void show();

  void set_events(WindowEvents events) { events_ = std::move(events); }

  // What vulkan::InstanceOptions::extensions must hold.
  std::vector<std::string> instance_extensions() const;

  // Destroyed before the window and the instance.
  vulkan::Result<vulkan::Surface> surface(const vulkan::Instance& instance) const;

  // While held, the pointer goes on at the other edge of the screen when it comes to one, and cursor events
  // go on counting: a drag may be as long as it likes.
  void hold_pointer(bool held);

  // Delivers what has happened.
  void poll();
  // The same; while the window is minimised it waits up to a tenth of a second for more.
  void poll_or_wait();

  // For other programs to paste.
  void copy(const std::string& text);

  void hide();
  bool closing() const;           // its close button was pressed, or it is lost
  bool lost() const;              // it went without being closed, see window_loss.h
  render::Extent pixels() const;  // of what is drawn; zero while minimised

private:
  explicit Window(GLFWwindow* window);
  void on_cursor(double x, double y);
  void wrap_pointer();

  GLFWwindow* window_;
  WindowEvents events_;
  std::optional<WrappedPointer> pointer_;  // while it is held
};

}  // namespace fulcrum::ui
