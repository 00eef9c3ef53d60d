#pragma once
// A hand on a SpaceMouse's cap. It sees where the handle is, some time later, as the run writes it; it learns
// what each axis does by pushing it, and then goes where it is told to by pushing toward what is missing.

#include <Eigen/Core>
#include <chrono>
#include <deque>
#include <functional>
#include <optional>

#include "tests/device_models/spacemouse_model.h"
#include "tests/drivers_kernel/trace_tail.h"

namespace fulcrum::test {

class CapHand {
public:
  // goes_on: false once there is nothing more to be seen.
  CapHand(SpaceMouseModel& cap, TraceTail& tail, std::function<bool()> goes_on)
      : cap_(cap), tail_(tail), goes_on_(std::move(goes_on)) {}

  // Where the handle is when the run begins.
  Pose begin();
  void learn();
  // In a straight line, in this time at least; then it stays for a while.
  void go(const Pose& X_WH, double travel_s, double dwell_s);

private:
  using Clock = std::chrono::steady_clock;
  using Vec6 = Eigen::Matrix<double, 6, 1>;  // a velocity, then an angular one, in W
  using Mat6 = Eigen::Matrix<double, 6, 6>;
  struct Push {
    Clock::time_point at;
    Vec6 twist;
  };

  // A moment passes, and what has come to be seen is seen.
  bool look();
  TraceRow next_row();
  Pose rest();
  // Where the handle must be now: where it was seen last, and what has been pushed since.
  Pose now_at() const;
  void push(const Vec6& twist);

  SpaceMouseModel& cap_;
  TraceTail& tail_;
  std::function<bool()> goes_on_;
  std::optional<TraceRow> seen_;
  bool fresh_ = false;         // it was seen in the last look
  Clock::time_point epoch_{};  // when, by this clock, the run's time was 0
  Mat6 full_ = Mat6::Zero();   // a column for each axis: what it brings at its stop
  std::deque<Push> pushes_;
  std::optional<Pose> goal_;  // the last one
};

}  // namespace fulcrum::test
