#include "tests/person/trainee.h"

#include <X11/keysym.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>
#include <utility>

#include "tests/person/clock.h"

namespace fulcrum::person {
namespace {

constexpr double kSpeed = 1000;     // px/s, of a hand that is sure of its way
constexpr double kLeast = 0.08;     // s, of the shortest drag
constexpr double kReport = 0.008;   // s, from one of a mouse's reports to the next
constexpr double kPause = 0.8;      // s
constexpr double kReaction = 0.05;  // s, from what is seen to a press

void rest(double seconds) {
  std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
}

// 0..1 in 0..1, without a jerk at its ends: how hands move (Flash and Hogan 1985).
double smooth(double t) {
  return t * t * t * (10 + t * (6 * t - 15));
}

}  // namespace

Sight Trainee::look() {
  last_ = window_.picture();
  width_ = last_.width;
  height_ = last_.height;
  return look_at(last_);
}

Sight Trainee::look_on(double seconds) {
  const auto began = Clock::now();
  rest(seconds);
  const Picture before = last_;
  const Sight seen = look();
  if (last_.rgb != before.rgb) ++frames_;
  moved_s_ += since(began);
  return seen;
}

Sight Trainee::wait_for_scene() {
  const auto began = Clock::now();
  while (since(began) < 120) {
    const Sight seen = look();
    if (seen.ring && (seen.touch || seen.lost)) return seen;
    rest(0.05);
  }
  throw GaveUp("neither ring nor tool came into the picture");
}

Sight Trainee::go_to_view(char number) {
  const Sight before = look();
  const auto symbol = static_cast<unsigned long>(static_cast<unsigned char>(number));
  press(symbol);
  // The ring goes elsewhere, if only by a pixel: where this view is shown already, nothing does.
  const auto pressed = Clock::now();
  Sight seen = before;
  while (since(pressed) < 2) {
    seen = look();
    if (seen.ring && before.ring && length(seen.ring->middle - before.ring->middle) > 1) break;
    rest(0.02);
  }
  return seen;
}

void Trainee::press(unsigned long key) {
  window_.press_key(key);
  rest(0.04);
  window_.release_key(key);
}

void Trainee::watch() {
  Picture now = window_.picture();
  if (now.rgb != last_.rgb) ++frames_;
  last_ = std::move(now);
}

void Trainee::drag(const Place& way, Button button, bool shift) {
  if (length(way) < 0.5) return;
  rest(kReaction);
  // From the middle, which no panel is in, and so that a long way stays on the screen.
  const Place from{width_ / 2, height_ / 2};
  window_.point_at(from);
  if (shift) window_.press_key(XK_Shift_L);
  window_.press(button);
  const double duration = std::max(kLeast, length(way) / kSpeed);
  const auto began = Clock::now();
  double seen_at = 0;
  for (double now = 0; now < duration; now = since(began)) {
    window_.point_at(from + way * smooth(now / duration));
    if (now - seen_at > 0.015) {
      watch();
      seen_at = now;
    }
    rest(kReport);
  }
  window_.point_at(from + way);
  moved_s_ += since(began);
  window_.release(button);
  if (shift) window_.release_key(XK_Shift_L);
}

void Trainee::slide(const Place& way) {
  drag(way, Button::left, false);
}

void Trainee::push(double farther) {
  drag({0, -farther}, Button::left, true);
}

void Trainee::roll(double clockwise) {
  drag({clockwise, 0}, Button::right, true);
}

void Trainee::stop_for_a_moment() {
  rest(kReaction);
  press(XK_Escape);
  rest(kPause);
  press(XK_Return);
}

Sight Trainee::settled(const Sight& before, const Place& expected, double farther) {
  const auto began = Clock::now();
  const double frame = frames_ > 0 ? std::clamp(moved_s_ / frames_, 0.02, 1.0) : 0.1;
  const auto apart = [](const Sight& a, const Sight& b) {
    return std::max(length(*a.touch - *b.touch), std::abs(a.farther - b.farther));
  };
  Sight seen = look();
  auto moved = Clock::now();
  bool has_moved = false;
  while (since(began) < 3 && seen.done == before.done) {
    if (seen.touch && since(began) > 0.03) {
      if (length(*seen.touch - expected) < 1.5 && std::abs(seen.farther - farther) < 4) break;
      has_moved = has_moved || !before.touch || apart(seen, before) > 2;
    }
    if (since(moved) > 0.1 + (has_moved ? 2.5 : 6) * frame) break;
    rest(0.015);
    const Sight now = look();
    if (!now.touch || !seen.touch || apart(now, seen) > 0.6) moved = Clock::now();
    seen = now;
  }
  return seen;
}

}  // namespace fulcrum::person
