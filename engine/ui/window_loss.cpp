#include "engine/ui/window_loss.h"

#include <atomic>

#include <GLFW/glfw3.h>
#include <X11/Xlib.h>

// As GLFW's native header has them, which asks for XRandR's header besides.
extern "C" {
Display* glfwGetX11Display(void);
Window glfwGetX11Window(GLFWwindow* window);
}

namespace fulcrum::ui {
namespace {

// A driver's threads talk to the server, too.
std::atomic<XID> watched{None};
std::atomic<bool> lost{false};

// A request named something that is not there. If that is the window, another program destroyed it; any other
// is no reason to end a run.
int on_error(Display*, XErrorEvent* error) {
  if (error->resourceid == watched) lost = true;
  return 0;
}

int on_broken_connection(Display*) {
  lost = true;
  return 0;
}

// In place of Xlib's own, which calls exit(). Were it to return, Xlib would write through a null pointer.
void after_broken_connection(Display*, void*) {
  if (detail::on_loss != nullptr) std::longjmp(*detail::on_loss, 1);
}

}  // namespace

std::jmp_buf* detail::on_loss = nullptr;

void watch_for_loss(GLFWwindow* window) {
  watched = glfwGetX11Window(window);
  lost = false;
  XSetErrorHandler(on_error);
  XSetIOErrorHandler(on_broken_connection);
  XSetIOErrorExitHandler(glfwGetX11Display(), after_broken_connection, nullptr);
}

bool window_lost() {
  return lost;
}

}  // namespace fulcrum::ui
