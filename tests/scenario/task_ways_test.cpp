// Each kind of task against motions whose truth is known on paper: a hand at a steady pace along lines, into
// bores, about axes.

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>

#include "engine/scenario/task_judge.h"
#include "haptics/math/rotation.h"
#include "haptics/safety/faults.h"

namespace fulcrum::scenario {
namespace {

constexpr double kStep = 1e-3, kDegree = std::numbers::pi / 180;
const Vec3 kTouchPoint(0.1, -0.02, 0.03);  // p_TC

// One hand, tick after tick.
class Hand {
public:
  explicit Hand(TaskDesc task)
      : judge_(
            [&] {
              task.touch_point = kTouchPoint;
              return std::move(task);
            }(),
            kStep) {}

  void be(const Vec3& p_WC, const Quat& q_WT = Quat::Identity(), double force = 0, int regions = 0) {
    TickRecord record;
    record.tick = tick_++;
    record.X_WT.q = q_WT;
    record.X_WT.p = p_WC - q_WT * kTouchPoint;
    record.contact_F_T_W.force = Vec3(0, force, 0);
    record.regions = regions;
    judge_.judge(record);
  }
  // A tick at each step from where it was, the last one at `to`.
  void go(const Vec3& to, double speed) {
    const Vec3 from = at_;
    const double ticks = std::ceil((to - from).norm() / speed / kStep);
    for (double i = 1; i <= ticks; ++i) be(from + i / ticks * (to - from));
    at_ = to;
  }
  void jump(const Vec3& to) { at_ = to; }
  void stay(double duration) {
    for (double i = 0; i < duration / kStep; ++i) be(at_, q_);
  }
  // About an axis through the touch point, at a rad/s.
  void turn(const Vec3& axis, double angle, double rate = 1) {
    const Quat from = q_;
    const double ticks = std::ceil(std::abs(angle) / rate / kStep);
    for (double i = 1; i <= ticks; ++i) be(at_, q_ = turn_by(i / ticks * angle, axis) * from);
  }
  // As it may be after a pause.
  void turned(double angle, const Vec3& axis) { q_ = turn_by(angle, axis) * q_; }
  void stop(std::int64_t ticks, const Vec3& p_WC) {
    for (std::int64_t i = 0; i < ticks; ++i) {
      TickRecord record;
      record.tick = tick_++;
      record.X_WT.p = p_WC - kTouchPoint;
      record.stopped = true;
      record.faults = kStopRequested;
      judge_.judge(record);
    }
  }

  const TaskState& state() const { return judge_.state(); }
  bool done(std::size_t i = 0) const { return judge_.state().reached[i].has_value(); }
  double now() const { return static_cast<double>(tick_) * kStep; }

private:
  TaskJudge judge_;
  std::int64_t tick_ = 0;
  Vec3 at_ = Vec3::Zero();
  Quat q_ = Quat::Identity();
};

TaskDesc one(Checkpoint checkpoint, double dwell = 0) {
  TaskDesc task;
  task.checkpoints.push_back(std::move(checkpoint));
  task.dwell = dwell;
  return task;
}

// 30 mm along x, then 40 mm along y.
Checkpoint angle_line() {
  Checkpoint line{"line", Vec3::Zero(), 0.002};
  line.follow = {Vec3(0.03, 0, 0), Vec3(0.03, 0.04, 0)};
  return line;
}

TEST(Follow, CountsWhereTheLineEnds) {
  Hand hand(one(angle_line(), 0.2));
  EXPECT_EQ(hand.state().way, 0);
  hand.be(Vec3::Zero());
  hand.go({0.03, 0, 0}, 0.05);
  EXPECT_NEAR(hand.state().way, 30.0 / 70, 1e-9);
  EXPECT_TRUE(hand.state().inside);
  // A diameter ahead of the hand, round the corner.
  EXPECT_LT((hand.state().place_W - Vec3(0.03, 0.004, 0)).norm(), 1e-12);
  hand.go({0.03, 0.04, 0}, 0.05);
  ASSERT_FALSE(hand.done());
  hand.stay(0.3);
  ASSERT_TRUE(hand.done());
  // There within the radius of the end, 68 mm on at 50 mm/s, and then 200 ms.
  EXPECT_NEAR(*hand.state().reached[0], 0.068 / 0.05 + 0.2, 1.5 * kStep);
  EXPECT_EQ(hand.state().slips, 0);
}

TEST(Follow, IsNoFartherOffThanTheRadius) {
  for (const double off : {0.0019, 0.0021}) {
    Hand hand(one(angle_line()));
    hand.be(Vec3::Zero());
    hand.go({0.005, 0, 0}, 0.05);
    hand.go({0.005, 0, off}, 0.05);
    hand.go({0.03, 0, off}, 0.05);
    hand.go({0.03, 0.04, 0}, 0.05);
    EXPECT_EQ(hand.done(), off < 0.002) << off;
    EXPECT_EQ(hand.state().slips, off < 0.002 ? 0 : 1) << off;
  }
}

TEST(Follow, AShortCutIsASlipAndGoesOnWhereItWasLeft) {
  Hand hand(one(angle_line()));
  hand.be(Vec3::Zero());
  hand.go({0.01, 0, 0}, 0.05);
  hand.go({0.03, 0.04, 0}, 0.05);  // straight to the end
  EXPECT_FALSE(hand.done());
  EXPECT_FALSE(hand.state().inside);
  EXPECT_EQ(hand.state().slips, 1);
  const double way = hand.state().way;
  EXPECT_GT(way, 10.0 / 70);
  EXPECT_LT(way, 20.0 / 70);
  hand.go({0.012, 0, 0}, 0.05);
  EXPECT_TRUE(hand.state().inside);
  hand.go({0.03, 0, 0}, 0.05);
  hand.go({0.03, 0.04, 0}, 0.05);
  EXPECT_TRUE(hand.done());
  EXPECT_EQ(hand.state().slips, 1);
}

TEST(Follow, BackwardsIsNoWay) {
  Hand hand(one(angle_line()));
  hand.jump({0.03, 0.04, 0});
  hand.go({0.03, 0, 0}, 0.05);
  EXPECT_EQ(hand.state().way, 0);
  hand.go({0, 0, 0}, 0.05);
  EXPECT_FALSE(hand.done());
  EXPECT_LE(hand.state().way, 2.0 / 70 + 1e-9);  // within the radius of its beginning
}

// A tremor of 0.3 mm at the rim is one slip, not hundreds.
TEST(Follow, ATremorAtTheRimIsOneSlip) {
  Hand hand(one(angle_line()));
  hand.be(Vec3::Zero());
  hand.go({0.015, 0, 0}, 0.05);
  for (int i = 0; i < 1000; ++i) hand.be({0.015, i % 2 == 0 ? 0.00185 : 0.00215, 0});
  EXPECT_EQ(hand.state().slips, 1);
}

// Whatever is needed is needed on all of the way: without it nothing is gained, and nothing lost.
TEST(Follow, GoesOnOnlyWithWhatItNeeds) {
  Checkpoint line = angle_line();
  line.needs = Needs::touch;
  Hand hand(one(line));
  for (int i = 0; i <= 300; ++i) {
    hand.be({1e-4 * i, 0, 0});
    if (i < 20) EXPECT_EQ(hand.state().lack, Lack::touch);
  }
  EXPECT_EQ(hand.state().way, 0);
  for (int i = 0; i <= 300; ++i) hand.be({1e-4 * i, 0, 0}, Quat::Identity(), 1, 1);
  EXPECT_NEAR(hand.state().way, 30.0 / 70, 1e-9);
  for (int i = 0; i <= 400; ++i) hand.be({0.03, 1e-4 * i, 0}, Quat::Identity(), 1, i < 200 ? 1 : 0);
  EXPECT_NEAR(hand.state().way, (30 + 19.9) / 70, 1e-9);
  EXPECT_FALSE(hand.done());
}

// Any line and any walk, against the rule said with the line as ten thousand points.
TEST(Follow, IsAsAFinePolylineHasIt) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> place(-0.02, 0.02), part(0, 1);
  int finished = 0;
  for (int round = 0; round < 60; ++round) {
    Checkpoint line{"line", Vec3::Zero(), 0.003};
    std::vector<Vec3> corners{line.position};
    double length = 0;
    for (int i = 0; i < 4; ++i) {
      line.follow.push_back(Vec3(place(random), place(random), place(random)));
      length += (line.follow.back() - corners.back()).norm();
      corners.push_back(line.follow.back());
    }
    constexpr int kPoints = 10000;
    std::vector<Vec3> points;
    for (int i = 0; i <= kPoints; ++i) {
      double along = length * i / kPoints;
      std::size_t leg = 0;
      while (leg + 2 < corners.size() && along > (corners[leg + 1] - corners[leg]).norm())
        along -= (corners[leg + 1] - corners[leg]).norm(), ++leg;
      points.push_back(corners[leg] + along * (corners[leg + 1] - corners[leg]).normalized());
    }
    Hand hand(one(line, 0.001));
    double at = 0;  // of the walk: along the line, and now and then off it
    int followed = 0;
    bool begun = false;
    while (at < length + 0.002) {
      at += 2e-4 * part(random);
      const auto nominal = static_cast<std::size_t>(std::min(1.0, at / length) * kPoints);
      const Vec3 p = points[nominal] + 0.0012 * Vec3(place(random), place(random), place(random)) / 0.02;
      hand.be(p);
      begun = begun || p.norm() <= line.radius;
      if (!begun) continue;
      int best = followed;
      const int last = std::min(kPoints, followed + static_cast<int>(2 * line.radius / length * kPoints));
      for (int i = followed; i <= last; ++i)
        if ((points[static_cast<std::size_t>(i)] - p).norm() <
            (points[static_cast<std::size_t>(best)] - p).norm())
          best = i;
      if (last == kPoints && (points.back() - p).norm() <= line.radius) best = kPoints;
      // From where the judge has it, a tick at a time: two legs may be as near as one another.
      followed = static_cast<int>(std::lround((hand.done() ? 1 : hand.state().way) * kPoints));
      const auto off = [&](int i) { return (points[static_cast<std::size_t>(i)] - p).norm(); };
      if (hand.state().inside || hand.done())
        ASSERT_NEAR(off(followed), off(best), 2e-5) << round;
      else  // once off it, it has to come nearer again than the radius
        ASSERT_GT(off(best), CheckpointWay::kBack * line.radius - 2e-5) << round;
    }
    finished += hand.done() ? 1 : 0;
  }
  EXPECT_GT(finished, 50);
}

Checkpoint bore() {
  Checkpoint bore{"bore", Vec3(0, 0.1, 0), 0.002};
  bore.insert = {Vec3(0, -1, 0), 0.02};
  return bore;
}

TEST(Insert, CountsAtItsDepth) {
  Hand hand(one(bore(), 0.1));
  hand.jump({0, 0.15, 0});
  hand.go({0, 0.09, 0}, 0.05);
  EXPECT_NEAR(hand.state().way, 0.5, 1e-9);
  EXPECT_LT((hand.state().place_W - Vec3(0, 0.08, 0)).norm(), 1e-12);
  hand.go({0, 0.0795, 0}, 0.05);
  hand.stay(0.2);
  ASSERT_TRUE(hand.done());
  EXPECT_NEAR(*hand.state().reached[0], 0.07 / 0.05 + 0.1, 1.5 * kStep);
  EXPECT_EQ(hand.state().slips, 0);
}

TEST(Insert, IsNotReachedFromTheSide) {
  Hand hand(one(bore()));
  hand.jump({0.05, 0.08, 0});
  hand.go({0, 0.08, 0}, 0.05);
  hand.stay(0.5);
  EXPECT_FALSE(hand.done());
  EXPECT_FALSE(hand.state().inside);
}

TEST(Insert, LeavingTheBoreIsASlipAndBeginsItAnew) {
  Hand hand(one(bore()));
  hand.jump({0, 0.1, 0});
  hand.go({0, 0.09, 0}, 0.05);
  hand.go({0.0025, 0.09, 0}, 0.05);
  EXPECT_EQ(hand.state().slips, 1);
  hand.go({0, 0.09, 0}, 0.05);
  hand.go({0, 0.08, 0}, 0.05);
  EXPECT_FALSE(hand.done());
  hand.go({0, 0.1, 0}, 0.05);
  hand.go({0, 0.08, 0}, 0.05);
  EXPECT_TRUE(hand.done());
}

TEST(Insert, TooDeepDoesNotCount) {
  Hand hand(one(bore(), 0.1));
  hand.jump({0, 0.1, 0});
  hand.go({0, 0.0775, 0}, 0.5);  // 2.5 mm beyond, with a radius of 2
  hand.stay(0.5);
  EXPECT_EQ(hand.state().lack, Lack::less_depth);
  EXPECT_FALSE(hand.done());
  hand.go({0, 0.079, 0}, 0.05);
  hand.stay(0.2);
  EXPECT_TRUE(hand.done());
}

Checkpoint screw(double degrees) {
  Checkpoint screw{"screw", Vec3::Zero(), 0.01};
  screw.turn = {Vec3(0, 0.6, 0.8), degrees * kDegree};
  return screw;
}

TEST(TurnBy, CountsAtItsAngle) {
  for (const double degrees : {5.0, 90.0, 180.0, 540.0}) {
    const Checkpoint checkpoint = screw(degrees);
    Hand hand(one(checkpoint));
    hand.be(Vec3::Zero());
    hand.turn(checkpoint.turn->axis_W, 1.1 * degrees * kDegree);
    ASSERT_TRUE(hand.done()) << degrees;
    EXPECT_NEAR(*hand.state().reached[0], degrees * kDegree, 2 * kStep + 1e-3 * degrees * kDegree) << degrees;
  }
}

TEST(TurnBy, TheOtherWayAndOtherAxesAreNoTurn) {
  const Checkpoint checkpoint = screw(30);
  Hand hand(one(checkpoint));
  hand.be(Vec3::Zero());
  hand.turn(checkpoint.turn->axis_W, -2);
  EXPECT_EQ(hand.state().way, 0);
  hand.turn(Vec3(0, 0.8, -0.6), 3);  // square to it
  EXPECT_LT(hand.state().way, 1e-6);
  EXPECT_FALSE(hand.done());
}

// A spanner has 60 degrees to go: it is lifted, taken back, and put on again.
TEST(TurnBy, MayBeMadeInSeveralGoes) {
  const Checkpoint checkpoint = screw(180);
  Hand hand(one(checkpoint));
  for (int stroke = 0; stroke < 3; ++stroke) {
    EXPECT_NEAR(hand.state().way, stroke * 60.5 / 180, 1e-9);
    hand.jump(Vec3::Zero());
    hand.stay(0.01);
    hand.turn(checkpoint.turn->axis_W, 60.5 * kDegree);
    hand.jump({0.05, 0, 0});
    hand.stay(0.01);
    hand.turn(checkpoint.turn->axis_W, -60.5 * kDegree);
  }
  EXPECT_TRUE(hand.done());
}

TEST(TurnBy, TurningBackIsTakenOff) {
  const Checkpoint checkpoint = screw(90);
  Hand hand(one(checkpoint));
  hand.be(Vec3::Zero());
  hand.turn(checkpoint.turn->axis_W, 60 * kDegree);
  hand.turn(checkpoint.turn->axis_W, -30 * kDegree);
  EXPECT_NEAR(hand.state().way, 1.0 / 3, 1e-6);
}

// q and -q are one rotation.
TEST(TurnBy, DoesNotAskForTheSignOfAQuaternion) {
  const Checkpoint checkpoint = screw(90);
  Hand hand(one(checkpoint));
  for (int i = 0; i <= 1000; ++i) {
    Quat q = turn_by(1e-3 * i, checkpoint.turn->axis_W);
    if (i % 3 == 0) q.coeffs() *= -1;
    hand.be(Vec3::Zero(), q);
  }
  EXPECT_NEAR(hand.state().way, 1 / (90 * kDegree), 1e-9);
}

TEST(ForceWithin, CountsBetweenTheTwo) {
  Checkpoint press{"press", Vec3::Zero(), 0.01};
  press.force = {1, 2};
  Hand hand(one(press, 0.1));
  const auto push = [&](double force, int ticks) {
    for (int i = 0; i < ticks; ++i) hand.be(Vec3::Zero(), Quat::Identity(), force, 1);
  };
  push(0.99, 500);
  EXPECT_EQ(hand.state().lack, Lack::more_force);
  push(2.01, 500);
  EXPECT_EQ(hand.state().lack, Lack::less_force);
  push(std::nan(""), 500);
  EXPECT_EQ(hand.state().lack, Lack::more_force);
  push(1.5, 100);
  EXPECT_FALSE(hand.done());
  push(2.5, 1);  // and the count begins anew
  push(1.5, 100);
  EXPECT_FALSE(hand.done());
  push(1, 1);
  EXPECT_TRUE(hand.done());
}

TEST(FacingWithin, IsTheAngleOfAnyTurn) {
  Checkpoint held{"held", Vec3::Zero(), 0.01};
  held.facing = {turn_by(1, Vec3(0.6, 0, 0.8)), 10 * kDegree};
  std::mt19937 random(3);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 200; ++i) {
    const Vec3 axis = Vec3(normal(random), normal(random), normal(random)).normalized();
    for (const double degrees : {9.99, 10.01}) {
      Hand hand(one(held));
      Quat q = turn_by(degrees * kDegree, axis) * held.facing->q_WT;
      if (i % 2 == 0) q.coeffs() *= -1;
      hand.be(Vec3::Zero(), q);
      EXPECT_EQ(hand.done(), degrees < 10) << degrees;
      EXPECT_EQ(hand.state().lack == Lack::facing, degrees > 10);
    }
  }
}

TaskDesc four(Order order) {
  TaskDesc task;
  for (int i = 0; i < 4; ++i)
    task.checkpoints.push_back({std::string(1, static_cast<char>('a' + i)), Vec3(0.1 * i, 0, 0), 0.01});
  task.dwell = 0.01;
  task.order = order;
  return task;
}

TEST(InAnyOrder, EachCountsAsItIsReached) {
  Hand hand(four(Order::any));
  for (const int i : {2, 0, 3, 1}) {
    EXPECT_FALSE(hand.state().completed);
    hand.jump({0.1 * i, 0, 0});
    hand.stay(0.005);
    EXPECT_EQ(hand.state().step, static_cast<std::size_t>(i));
    hand.stay(0.02);
    EXPECT_TRUE(hand.done(static_cast<std::size_t>(i)));
  }
  EXPECT_TRUE(hand.state().completed);
}

TEST(InAnyOrder, OneThatComesAfterAnotherWaitsForThat) {
  TaskDesc task = four(Order::any);
  task.checkpoints[3].after = "b";
  Hand hand(task);
  hand.jump({0.3, 0, 0});
  hand.stay(0.05);
  EXPECT_FALSE(hand.done(3));
  EXPECT_FALSE(hand.state().open[3]);
  hand.jump({0.1, 0, 0});
  hand.stay(0.05);
  EXPECT_TRUE(hand.state().open[3]);
  hand.jump({0.3, 0, 0});
  hand.stay(0.05);
  EXPECT_TRUE(hand.done(3));
}

TEST(InTheOrderGiven, AnOptionalOneMayBePassed) {
  TaskDesc task = four(Order::given);
  task.checkpoints[1].optional = true;
  for (const bool takes_it : {false, true}) {
    Hand hand(task);
    for (const int i : {0, 1, 2, 1, 3}) {
      if (i == 1 && !takes_it && !hand.done(2)) continue;  // later it is too late
      hand.jump({0.1 * i, 0, 0});
      hand.stay(0.05);
    }
    EXPECT_TRUE(hand.state().completed);
    EXPECT_EQ(hand.done(1), takes_it);
  }
}

// Two in one place: what one of them lacks keeps nobody from the other.
TEST(InAnyOrder, OneThatLacksSomethingDoesNotHoldUpAnother) {
  TaskDesc task = four(Order::any);
  task.checkpoints[1].position = task.checkpoints[0].position;
  task.checkpoints[0].needs = Needs::touch;
  Hand hand(task);
  hand.jump({0, 0, 0});
  hand.stay(0.05);
  EXPECT_FALSE(hand.done(0));
  EXPECT_TRUE(hand.done(1));
  EXPECT_EQ(hand.state().lack, Lack::touch) << "then the other one is told";
}

TEST(InTheOrderGiven, AnOptionalOneRoundARequiredOneDoesNotHoldItUp) {
  TaskDesc task = four(Order::given);
  task.checkpoints[0].optional = true;
  task.checkpoints[0].radius = 0.05;
  task.checkpoints[0].facing = {turn_by(2, Vec3::UnitX()), 0.1};
  task.checkpoints[1].position = task.checkpoints[0].position;
  Hand hand(task);
  hand.jump({0, 0, 0});
  hand.stay(0.05);
  EXPECT_FALSE(hand.done(0));
  EXPECT_TRUE(hand.done(1));
}

// In a pause nothing is judged: what is turned and left in it is neither a turn nor a slip.
TEST(InAPause, NoTurnAndNoSlipIsCounted) {
  Hand screws(one(screw(90)));
  screws.be(Vec3::Zero());
  screws.turn(screw(90).turn->axis_W, 60 * kDegree);
  screws.stop(10, {0.5, 0, 0});
  screws.turned(120 * kDegree, screw(90).turn->axis_W);
  screws.stay(0.1);
  EXPECT_NEAR(screws.state().way, 60.0 / 90, 1e-6);
  EXPECT_FALSE(screws.done());

  Hand follows(one(angle_line()));
  follows.be(Vec3::Zero());
  follows.go({0.01, 0, 0}, 0.05);
  follows.stop(10, {0.5, 0, 0});
  follows.jump({0.5, 0, 0});
  follows.stay(0.01);
  EXPECT_EQ(follows.state().slips, 0);
  follows.jump({0.01, 0, 0});
  follows.stay(0.01);
  follows.jump({0.5, 0, 0});
  follows.stay(0.01);
  EXPECT_EQ(follows.state().slips, 1) << "without a pause it is one";
}

TEST(Dwell, IsItsOwnWhereItHasOne) {
  TaskDesc task = four(Order::any);
  task.checkpoints[1].dwell = 0.5;
  Hand hand(task);
  hand.jump({0.1, 0, 0});
  hand.stay(0.4);
  EXPECT_NEAR(hand.state().dwell_progress, 0.8, 1e-2);
  hand.stay(0.15);
  EXPECT_NEAR(*hand.state().reached[1], 0.5, 1e-9);
}

TEST(Avoid, EachTimeIsCountedAndItsDuration) {
  TaskDesc task = four(Order::given);
  task.avoid = {{"nerve", Vec3(0, 0.5, 0), 0.01}, {"vessel", Vec3(0, 0.505, 0), 0.01}};
  Hand hand(task);
  const auto be = [&](double y, int ticks) {
    for (int i = 0; i < ticks; ++i) hand.be({0, y, 0});
  };
  be(0.485, 10);
  EXPECT_EQ(hand.state().trespasses, 0);
  be(0.4901, 10);  // in the nerve alone
  EXPECT_EQ(hand.state().trespasses, 1);
  be(0.4895, 10);  // a little out of it, as a tremor is
  be(0.4901, 10);
  EXPECT_EQ(hand.state().trespasses, 1);
  EXPECT_NEAR(hand.state().trespass_time, 0.02, 1e-12);
  be(0.502, 10);  // in both
  EXPECT_EQ(hand.state().trespasses, 2);
  EXPECT_NEAR(hand.state().trespass_time, 0.03, 1e-12);
  be(std::nan(""), 10);
  hand.stop(10, {0, 0.5, 0});  // a pause
  EXPECT_NEAR(hand.state().trespass_time, 0.03, 1e-12);
}

TEST(StateAfter, IsThatOfAJudgeWhoSawItReached) {
  TaskDesc task = four(Order::given);
  task.checkpoints[1].optional = true;
  Hand hand(task);
  hand.jump({0, 0, 0});
  hand.stay(0.05);
  hand.jump({0, 1, 0});
  hand.stay(0.05);
  const TaskState after = state_after(task, hand.state().reached);
  EXPECT_EQ(after.step, hand.state().step);
  EXPECT_EQ(after.open, hand.state().open);
  EXPECT_EQ(after.place_W, hand.state().place_W);
  EXPECT_EQ(after.completed, hand.state().completed);
}

}  // namespace
}  // namespace fulcrum::scenario
