#pragma once
// A pointer that goes on at the other edge of the screen. Arithmetic alone: no window in here.

#include <optional>

namespace fulcrum::ui {

// In a window's coordinates, y down. Empty until something is added.
struct ScreenArea {
  double left = 0, top = 0, right = 0, bottom = 0;  // pixels `right` and `bottom` are no longer in it
  void add(double x, double y, double width, double height);
};

class WrappedPointer {
public:
  WrappedPointer(double x, double y, const ScreenArea& area) : area_(area), at_{x, y}, sum_{x, y} {}

  // The pointer is at this place of the screen.
  void move(double x, double y);
  // Where it would be, had the screen no edges.
  double x() const { return sum_.x; }
  double y() const { return sum_.y; }

  struct Place {
    double x = 0, y = 0;
  };
  // Where the pointer is to be put, if it is at an edge.
  std::optional<Place> jump();

private:
  ScreenArea area_;
  Place at_, sum_;
  Place jumped_;  // how far the last jump went; zero once the pointer is known to be beyond it
};

}  // namespace fulcrum::ui
