#include "engine/app/author/path_fit.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/rotation.h"

namespace fulcrum::app {
namespace {

constexpr double kRestAtStart = 0.5;       // s
constexpr double kShortestRest = 0.3;      // s, that is a rest and no turning point
constexpr double kShortestTravel = 0.005;  // s, between waypoints: less is tremor

// A place of the path: it is there from `first` to `last`, both samples.
struct Knot {
  std::size_t first = 0, last = 0;
};

class Fitter {
public:
  Fitter(std::span<const Pose> samples, double tick_s, const PathTolerance& tolerance)
      : samples_(samples), tick_s_(tick_s), tolerance_(tolerance) {}

  FittedPath take() {
    find_rests();
    while (insert_worst()) {
    }
    FittedPath fitted{.waypoints = waypoints(),
                      .position_error = 0,
                      .angle_error_rad = 0,
                      .trimmed_start = static_cast<double>(begin_) * tick_s_};
    const HandPath path(fitted.waypoints);
    for (std::size_t i = begin_; i < samples_.size(); ++i) {
      const Pose at = path.at(time_of(i));
      fitted.position_error = std::max(fitted.position_error, (at.p - samples_[i].p).norm());
      fitted.angle_error_rad = std::max(fitted.angle_error_rad, angle_between(at.q, samples_[i].q));
    }
    return fitted;
  }

private:
  double time_of(std::size_t i) const { return static_cast<double>(i - begin_) * tick_s_; }
  std::size_t ticks(double time) const {
    return static_cast<std::size_t>(std::max(1.0, std::round(time / tick_s_)));
  }

  // 1: at the tolerance.
  double deviation(const Pose& a, const Pose& b) const {
    return std::max((a.p - b.p).norm() / tolerance_.position, angle_between(a.q, b.q) / tolerance_.angle_rad);
  }

  // Where the motion stays within half the tolerance of where it came to.
  void find_rests() {
    std::size_t i = 0;
    while (i < samples_.size()) {
      std::size_t end = i + 1;
      while (end < samples_.size() && deviation(samples_[end], samples_[i]) <= 0.5) ++end;
      const bool rests = end - i >= ticks(kShortestRest);
      if (rests) knots_.push_back({i, end - 1});
      i = rests ? end : i + 1;
    }
    const std::size_t last = samples_.size() - 1;
    if (knots_.empty() || knots_.front().first > 0) knots_.insert(knots_.begin(), Knot{0, 0});
    if (knots_.back().last < last) knots_.push_back({last, last});
    begin_ = knots_.front().last - std::min(knots_.front().last, ticks(kRestAtStart));
    knots_.front().first = begin_;
    if (knots_.size() == 1) {  // it never moved
      const std::size_t middle = (begin_ + last) / 2;
      knots_ = {{begin_, middle}, {std::min(middle + 1, last), last}};
    }
  }

  std::vector<Waypoint> waypoints() const {
    std::vector<Waypoint> waypoints;
    for (std::size_t k = 0; k < knots_.size(); ++k) {
      const Knot& knot = knots_[k];
      Waypoint& waypoint = waypoints.emplace_back(Waypoint{.X_WT = {}, .travel = 0});
      waypoint.X_WT = samples_[(knot.first + knot.last) / 2];
      waypoint.dwell = static_cast<double>(knot.last - knot.first) * tick_s_;
      if (k > 0)
        waypoint.travel = tick_s_ * std::max(1.0, static_cast<double>(knot.first) -
                                                      static_cast<double>(knots_[k - 1].last));
      waypoint.through = k > 0 && k + 1 < knots_.size() && knot.first == knot.last;
    }
    return waypoints;
  }

  // A knot at the worst sample of each stretch that is beyond the tolerance. False: there is none, or no
  // room.
  bool insert_worst() {
    const HandPath path(waypoints());
    std::vector<Knot> found;
    for (std::size_t k = 0; k + 1 < knots_.size(); ++k) {
      const std::size_t from = knots_[k].last, to = knots_[k + 1].first, room = ticks(kShortestTravel);
      std::size_t worst = 0;
      double largest = 1;
      for (std::size_t i = from + room; i + room <= to; ++i) {
        const double here = deviation(path.at(time_of(i)), samples_[i]);
        if (here <= largest) continue;
        largest = here;
        worst = i;
      }
      if (largest > 1) found.push_back({worst, worst});
    }
    knots_.insert(knots_.end(), found.begin(), found.end());
    std::ranges::sort(knots_, {}, &Knot::first);
    return !found.empty();
  }

  std::span<const Pose> samples_;
  double tick_s_;
  PathTolerance tolerance_;
  std::vector<Knot> knots_;
  std::size_t begin_ = 0;
};

}  // namespace

FittedPath fit_path(std::span<const Pose> samples, double tick_s, const PathTolerance& tolerance) {
  return Fitter(samples, tick_s, tolerance).take();
}

}  // namespace fulcrum::app
