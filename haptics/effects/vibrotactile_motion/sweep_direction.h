#pragma once
// Which way something goes along a line, from its place alone, without the chatter of a velocity's sign: it
// has turned round once it is `least` back from the farthest it got, and it rests once it has not gone on by
// that much for kRest. A hand that holds still trembles by 0.05 mm
// rms (device/hand.h), seldom by more than 0.25 mm from one side to the other; that much in kRest is 1.7
// mm/s.

#include <algorithm>

namespace fulcrum {

class SweepDirection {
public:
  static constexpr double kMin = 0.25e-3;  // m
  static constexpr double kRest = 0.15;    // s

  SweepDirection(double least, double tick_s) : least_(least), tick_s_(tick_s) {}

  // x (m): once a tick, and finite. Answers -1 or 1; 0: it rests, or has not gone yet.
  int update(double x) noexcept {
    if (!started_) far_ = mark_ = x;
    started_ = true;
    still_ += tick_s_;
    const int towards = sign_ != 0 ? sign_ : (x > mark_ ? 1 : -1);
    if (towards * (x - far_) > 0) far_ = x;
    if (towards * (x - far_) <= -least_)
      go(-towards, x);
    else if (towards * (x - mark_) >= least_)
      go(towards, x);
    return still_ < kRest ? sign_ : 0;
  }

private:
  void go(int sign, double x) noexcept {
    sign_ = sign;
    far_ = mark_ = x;
    still_ = 0;
  }

  double least_, tick_s_;
  bool started_ = false;
  int sign_ = 0;
  double far_ = 0;    // m, the farthest that it got in its direction
  double mark_ = 0;   // m, where it was last known to go on
  double still_ = 0;  // s since then
};

}  // namespace fulcrum
