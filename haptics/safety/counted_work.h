#pragma once
// The work that a hand did on a handle whose encoders count in steps, against forces that were held from tick
// to tick: about how much, and the least that it can have been.
//
// A count says when the handle crossed the border between two steps, to a tick. From one count to the next it
// is taken to have gone evenly, from border to border: with F held in each of the n ticks between them,
//     E = -sum_i mean(F)_i D_i,    D_i: a step for a count the same way as the last one, nothing for the
//     first one back
// which is exact where a tick sees many steps or the force does not change between counts. The handle is seen
// beyond a border up to a tick late. What it gets for nothing there, where the force falls in the direction
// in which it goes, is
//     E_i' = late_i min(0, d_i (mean(F)_(i+1) - mean(F)_i)),    d_i = +-1: the direction of the count
// At an acceleration that does not change from one count to the next, no tick sees more than twice the mean
// way, and where the handle turns within a step four times a step over n; never more than a step, and as the
// speed at a border is that of both sides, the smaller of the two. With these for late_i, and the rest of the
// way since the last count such that it costs most, this is the least that E can have been for every motion
// that is no more curved than a parabola from count to count: a hand's, a tremor's. A handle that stands
// still and then jumps by about a step within one tick can hide more, up to step |change of force| for each
// such count.
//
// It reads below the truth by about as much as the hold makes, k v T a metre on a spring, and by not more
// than k step a metre, the friction that makes such a wall passive (N. Diolaiti, G. Niemeyer, F. Barbagli, J.
// K. Salisbury, "Stability of haptic rendering: discretization, quantization, time delay, and Coulomb
// effects", IEEE Trans. Robotics 22(2), 2006).

#include <array>

#include "haptics/math/linear.h"

namespace fulcrum {

class CountedWork {
public:
  // step (6): of one count in each axis, m and rad; 0: the axis is exact.
  explicit CountedWork(const Vec6& step);

  // From here on, with F (6) N and N m on the handle.
  void open(const Vec6& F) noexcept;
  // d (6) m and rad: what was counted since the last call, under its F; F: from now on.
  void book(const Vec6& d, const Vec6& F) noexcept;

  double likely() const noexcept;  // J: seen half as late as can be
  double least()
      const noexcept;  // J: as late as can be, and with what may have happened since the last count
  // J, of least(): what it would be if nothing had happened since the last count.
  double least_counted() const noexcept;

private:
  struct Axis {
    double step = 0;
    double work = 0, late = 0, likely_late = 0;  // J; late <= 0
    double F = 0;
    double sum = 0;     // N or N m: of F, over the ticks since the last count
    int ticks = 0;      // since then
    int direction = 0;  // of that count; 0: none has come
    double mean = 0,
           reach = 0;          // of F between the last two counts; m or rad, the largest way of a tick there
    double low = 0, high = 0;  // of F since the last count, along its direction

    void open(double F_now) noexcept;
    void book(double d, double F_now) noexcept;
    void count(double d) noexcept;
    double pending() const noexcept;  // J, at least, since the last count
  };
  std::array<Axis, 6> axes_;
};

}  // namespace fulcrum
