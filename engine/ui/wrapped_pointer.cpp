#include "engine/ui/wrapped_pointer.h"

#include <algorithm>
#include <cmath>

namespace fulcrum::ui {
namespace {

constexpr double kInside = 2;  // pixels from the edge, where a jump ends: at the edge it would jump back

// From `last` to `now`, where a jump may lie between the two. It is as wide as the screen, and no hand moves
// half of that between two events.
double way(double last, double now, double& jumped) {
  const double moved = now - last;
  if (jumped == 0 || std::abs(moved) < std::abs(jumped) / 2) return moved;
  const double way = moved - jumped;
  jumped = 0;
  return way;
}

// From the edge at which `at` is to the other one; 0: it is at none.
double across(double at, double low, double high) {
  const double width = high - low - 2 * kInside;
  if (width <= 4 * kInside) return 0;
  if (at <= low) return width;
  return at >= high - 1 ? -width : 0;
}

}  // namespace

void ScreenArea::add(double x, double y, double width, double height) {
  const bool empty = left == right;
  left = empty ? x : std::min(left, x);
  top = empty ? y : std::min(top, y);
  right = empty ? x + width : std::max(right, x + width);
  bottom = empty ? y + height : std::max(bottom, y + height);
}

void WrappedPointer::move(double x, double y) {
  sum_.x += way(at_.x, x, jumped_.x);
  sum_.y += way(at_.y, y, jumped_.y);
  at_ = {x, y};
}

std::optional<WrappedPointer::Place> WrappedPointer::jump() {
  if (jumped_.x != 0 || jumped_.y != 0) return std::nullopt;  // one is still on its way
  jumped_ = {across(at_.x, area_.left, area_.right), across(at_.y, area_.top, area_.bottom)};
  if (jumped_.x == 0 && jumped_.y == 0) return std::nullopt;
  return Place{at_.x + jumped_.x, at_.y + jumped_.y};
}

}  // namespace fulcrum::ui
