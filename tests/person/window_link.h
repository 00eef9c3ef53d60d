#pragma once
// A window as a person has it: its picture, and a mouse and keys on its display. Nothing else is asked of it.

#include <memory>

#include "tests/person/picture.h"

namespace fulcrum::person {

enum class Button : unsigned { left = 1, right = 3 };  // X's numbers

class WindowLink {
public:
  // window: its number on the display of $DISPLAY. Throws std::runtime_error where there is none, or no
  // XTest.
  explicit WindowLink(unsigned long window);
  ~WindowLink();
  WindowLink(const WindowLink&) = delete;
  WindowLink& operator=(const WindowLink&) = delete;

  // Throws std::runtime_error once the window is gone.
  Picture picture();

  void point_at(const Place& place);
  void press(Button button);
  void release(Button button);
  void press_key(unsigned long symbol);  // X's name of it
  void release_key(unsigned long symbol);

private:
  class Implementation;
  std::unique_ptr<Implementation> implementation_;
};

}  // namespace fulcrum::person
