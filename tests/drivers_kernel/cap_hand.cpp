#include "tests/drivers_kernel/cap_hand.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <cmath>
#include <thread>

#include "haptics/math/rotation.h"

namespace fulcrum::test {
namespace {

using std::chrono::duration;
using std::chrono::duration_cast;

constexpr std::chrono::milliseconds kLook{8};
constexpr double kReach_s =
    0.025;                    // from a push to the handle's motion: a report, and the lag of rate control
constexpr double kHaste = 4;  // 1/s, of what is missing
constexpr double kNear = 5e-3, kNearAngle = 0.05;  // m, rad: so far from its goal it waits for itself
constexpr double kMost = 0.8;                      // of a full push
constexpr double kLearning = 0.5;                  // of a full push, which brings its square
constexpr double kLearning_s = 0.4;

// From one pose to another, in W.
Eigen::Matrix<double, 6, 1> way(const Pose& from, const Pose& to) {
  const Eigen::AngleAxisd turn(to.q * from.q.conjugate());
  Eigen::Matrix<double, 6, 1> both;
  const double angle = std::remainder(turn.angle(), 2 * static_cast<double>(EIGEN_PI));
  both << to.p - from.p, angle * turn.axis();
  return both;
}

Pose moved(const Pose& from, const Eigen::Matrix<double, 6, 1>& by) {
  const Vec3 turn = by.tail<3>();
  Pose to = from;
  to.p += by.head<3>();
  to.q = (quaternion_exp(turn) * from.q).normalized();
  return to;
}

}  // namespace

bool CapHand::look() {
  std::this_thread::sleep_for(kLook);
  fresh_ = false;
  if (std::optional<TraceRow> row = tail_.newest()) {
    seen_ = row;
    fresh_ = true;
    // Some rows come sooner after their tick than others: the soonest tell best when the run began.
    const Clock::time_point epoch =
        Clock::now() - duration_cast<Clock::duration>(duration<double>(row->time));
    epoch_ = epoch_ == Clock::time_point() ? epoch : std::min(epoch_, epoch);
  }
  return goes_on_();
}

TraceRow CapHand::next_row() {
  while (look() && !fresh_) {
  }
  return seen_.value_or(TraceRow());
}

Pose CapHand::begin() {
  return next_row().X_WH;
}

Pose CapHand::rest() {
  cap_.push({});
  Pose last = next_row().X_WH;
  while (goes_on_()) {
    const Pose now = next_row().X_WH;
    if (way(last, now).norm() < 1e-9) break;
    last = now;
  }
  return last;
}

void CapHand::learn() {
  for (int axis = 0; axis < 6; ++axis) {
    rest();
    std::array<int, 6> readings{};
    readings[static_cast<std::size_t>(axis)] =
        static_cast<int>(std::lround(kLearning * SpaceMouseModel::kFull));
    cap_.push(readings);
    const Clock::time_point until =
        Clock::now() + duration_cast<Clock::duration>(duration<double>(kLearning_s));
    Vec6 fastest = Vec6::Zero();
    for (TraceRow last = next_row(); Clock::now() < until && goes_on_();) {
      const TraceRow row = next_row();
      const Vec6 twist = way(last.X_WH, row.X_WH) / std::max(row.time - last.time, 1e-3);
      if (twist.norm() > fastest.norm()) fastest = twist;
      last = row;
    }
    full_.col(axis) = fastest / (kLearning * kLearning);
  }
  goal_ = rest();
}

Pose CapHand::now_at() const {
  const Clock::time_point last =
      epoch_ + duration_cast<Clock::duration>(duration<double>(seen_->time - kReach_s));
  Pose at = seen_->X_WH;
  for (std::size_t i = 0; i < pushes_.size(); ++i) {
    const Clock::time_point end = i + 1 < pushes_.size() ? pushes_[i + 1].at : Clock::now();
    const double felt_s = duration<double>(end - std::max(pushes_[i].at, last)).count();
    if (felt_s > 0) at = moved(at, felt_s * pushes_[i].twist);
  }
  return at;
}

void CapHand::push(const Vec6& twist) {
  const Vec6 shares = full_.partialPivLu().solve(twist).cwiseMax(-kMost).cwiseMin(kMost);
  std::array<int, 6> readings{};
  for (int axis = 0; axis < 6; ++axis)
    readings[static_cast<std::size_t>(axis)] = static_cast<int>(
        std::lround(std::copysign(std::sqrt(std::abs(shares[axis])), shares[axis]) * SpaceMouseModel::kFull));
  cap_.push(readings);
  pushes_.push_back({Clock::now(), full_ * shares});
  while (pushes_.size() > 2 && pushes_.front().at < Clock::now() - std::chrono::seconds(1))
    pushes_.pop_front();
}

void CapHand::go(const Pose& X_WH, double travel_s, double dwell_s) {
  const Pose from = *goal_;
  const Vec6 whole = way(from, X_WH);
  goal_ = X_WH;
  double gone_s = 0;
  for (Clock::time_point last = Clock::now(); gone_s < travel_s + dwell_s && look();) {
    const Clock::time_point now = Clock::now();
    const bool travels = gone_s < travel_s;
    const Vec6 missing = way(now_at(), moved(from, std::min(gone_s / travel_s, 1.0) * whole));
    push(kHaste * missing + (travels ? Vec6(whole / travel_s) : Vec6(Vec6::Zero())));
    const bool near = missing.head<3>().norm() < kNear && missing.tail<3>().norm() < kNearAngle;
    if (near) gone_s += duration<double>(now - last).count();
    last = now;
  }
}

}  // namespace fulcrum::test
