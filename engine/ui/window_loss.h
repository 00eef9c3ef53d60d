#pragma once
// A window can go without being closed: its X server dies, the connection to it is cut, another program
// destroys the window. Xlib ends the program then, in the middle of whatever it does. From watch_for_loss()
// on it goes on instead, and this says so.

#include <csetjmp>

struct GLFWwindow;

namespace fulcrum::ui {

// Of one window at a time, since Xlib's handlers are the process's.
void watch_for_loss(GLFWwindow* window);
// Nothing may be asked of GLFW any more, not even to clean up.
bool window_lost();

namespace detail {
extern std::jmp_buf* on_loss;  // of the innermost ask_display(); null: none
}

// Asks GLFW something that may have to ask the X server. False: the connection is lost, and `ask` was not
// run or was left halfway, out of Xlib, which cannot go on from there: its requests have nowhere to be
// written. Between `ask` and Xlib there may be nothing but C.
template <class Ask>
bool ask_display(const Ask& ask) {
  if (window_lost()) return false;
  std::jmp_buf here;
  std::jmp_buf* const outer = detail::on_loss;
  detail::on_loss = &here;
  const bool answered = setjmp(here) == 0;
  if (answered) ask();
  detail::on_loss = outer;
  return answered && !window_lost();
}

}  // namespace fulcrum::ui
