#include "haptics/safety/counted_work.h"

#include <algorithm>
#include <cmath>

#include "haptics/estimate/encoder_motion.h"

namespace fulcrum {
namespace {

constexpr double kCurved = 2;    // times the mean way: the largest of a tick between two counts
constexpr double kLikely = 0.5;  // of the largest lateness: twice what it is in the mean of a steady way

}  // namespace

CountedWork::CountedWork(const Vec6& step) {
  for (std::size_t i = 0; i < axes_.size(); ++i) axes_[i].step = step[static_cast<Eigen::Index>(i)];
}

void CountedWork::open(const Vec6& F) noexcept {
  for (std::size_t i = 0; i < axes_.size(); ++i) axes_[i].open(F[static_cast<Eigen::Index>(i)]);
}

void CountedWork::book(const Vec6& d, const Vec6& F) noexcept {
  for (std::size_t i = 0; i < axes_.size(); ++i) {
    const auto axis = static_cast<Eigen::Index>(i);
    axes_[i].book(d[axis], F[axis]);
  }
}

void CountedWork::Axis::open(double F_now) noexcept {
  *this = {.step = step, .F = F_now, .low = F_now, .high = F_now};
}

void CountedWork::Axis::book(double d, double F_now) noexcept {
  ++ticks;
  sum += F;
  if (d != 0) count(d);
  if (d != 0 && direction != 0) low = high = direction * F_now;
  F = F_now;
  const double along = direction != 0 ? direction * F : F;
  low = std::min(low, along);
  high = std::max(high, along);
}

void CountedWork::Axis::count(double d) noexcept {
  const int way = d > 0 ? 1 : -1;
  const double before = mean, reach_before = reach;
  const bool back = direction != 0 && way != direction;
  mean = sum / ticks;
  const bool leaps = std::abs(d) > kOneCount * step;  // it went a whole step within this tick
  const double way_in_all = std::abs(d) + (back ? step : 0.0);
  reach = leaps ? step : std::min(step, kCurved * way_in_all / std::max(1, ticks - 1));
  if (direction == 0)  // it began anywhere within its step
    work += std::min(0.0, -way * mean * step) - mean * (d - way * step);
  else
    work -= mean * (back ? d - way * step : d);
  if (direction != 0) {
    const double gets = std::min(reach, reach_before) * direction * (mean - before);
    late += std::min(0.0, gets);
    likely_late += kLikely * gets;
  }
  direction = way;
  ticks = 0;
  sum = 0;
}

// From anywhere within a tick's way of the border to anywhere within the step.
double CountedWork::Axis::pending() const noexcept {
  if (direction == 0) return -step * std::max(std::abs(low), std::abs(high));
  const double before = direction * mean;
  return step * std::min({0.0, -before, -high, low - before});
}

double CountedWork::likely() const noexcept {
  double sum = 0;
  for (const Axis& axis : axes_) sum += axis.work + axis.likely_late;
  return sum;
}

double CountedWork::least_counted() const noexcept {
  double sum = 0;
  for (const Axis& axis : axes_) sum += axis.work + axis.late;
  return sum;
}

double CountedWork::least() const noexcept {
  double sum = least_counted();
  for (const Axis& axis : axes_) sum += axis.pending();
  return sum;
}

}  // namespace fulcrum
