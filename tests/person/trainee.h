#pragma once
// A trainee at a window: looks, drags, looks again. Moves as fast as a hand on a mouse does.

#include <stdexcept>

#include "tests/person/sight.h"
#include "tests/person/window_link.h"

namespace fulcrum::person {

// The trial is over, or there is nothing left that the trainee could do.
struct GaveUp : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Trainee {
public:
  explicit Trainee(WindowLink& window) : window_(window) {}

  // Until the ring is in the picture, and the mark or the way to the tool.
  Sight wait_for_scene();
  // By the key of that number.
  Sight go_to_view(char number);

  // Drags of so many pixels. The tool follows one to one.
  void slide(const Place& way);
  void push(double farther);
  void roll(double clockwise);
  // By Esc, and on again by Enter.
  void stop_for_a_moment();

  // After a drag: looks until the mark is where it is expected, and as deep, or rests elsewhere. A picture is
  // older than the hand: a mark that has not moved from `before` does not rest yet.
  Sight settled(const Sight& before, const Place& expected, double farther);
  Sight look();
  // After a moment in which something moves.
  Sight look_on(double seconds);

  // Of those seen while something moved; 0: nothing did.
  double frames_per_second() const { return moved_s_ > 0 ? frames_ / moved_s_ : 0; }
  double height() const { return height_; }  // px, of the picture

private:
  void press(unsigned long key);
  void drag(const Place& way, Button button, bool shift);
  void watch();

  WindowLink& window_;
  double width_ = 0, height_ = 0;  // px
  Picture last_;
  double frames_ = 0, moved_s_ = 0;
};

}  // namespace fulcrum::person
