#include "haptics/contact/feature_lookahead.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

constexpr double kUnmoved = 1e-8;     // m and rad, around a look that must do with what it needs
constexpr double kStill = 1e-12;      // m, a slower tool stands still
constexpr double kLeastRoom = 50e-6;  // m, around what is gathered at once
constexpr double kNextRoom = 100e-6;  // m, around a way of the next gathering
constexpr double kMostRoom = 2e-3;    // m, around either where there is little
// How far beside its way a tool that swerves is looked for, and how far along it.
constexpr double kMostSwerve = 250e-6;  // m
constexpr double kMostTurn = 0.1;       // rad
constexpr double kLongestWay = 2e-3;    // m
constexpr double kLooks = 8;            // that a gathering is for, and that the next one has time for
constexpr double kStraight = 0.25;      // of how far the tool goes: who swerves by less goes straight
constexpr double kForgetting = 0.75;    // of how the tool moved, in each look
// How far ahead the next one looks: half as far after one that was too much, and then a little farther again.
constexpr double kLeastScale = 0.1, kGrowth = 1.1;
constexpr std::size_t kEnough = 8192;        // candidates of a kind: more are too much
constexpr std::size_t kEnoughVisits = 2048;  // at once, beyond what is needed: more are too much
constexpr std::size_t kManyVisits = 16384;   // in shares likewise
constexpr std::size_t kFewVisits = 512;      // so little may be gathered from farther around the next time
constexpr std::size_t kLeastVisits = 128;    // in a share
constexpr double kMostServed = 100;          // looks: a gathering that served for more tells of no more haste

}  // namespace

FeatureLookahead::FeatureLookahead(const FeatureMesh& tool_T, const FeatureMesh& scene_W, double slack,
                                   double deepest)
    : radius_(tool_T.radius()),
      gathering_(std::make_unique<FeatureGathering>(tool_T, scene_W, slack, deepest)),
      next_(std::make_unique<FeatureGathering>(tool_T, scene_W, slack, deepest)),
      room_(kLeastRoom) {}

bool FeatureLookahead::look(const Pose& X_WT, const Vec6& ahead, double reach, std::size_t most) noexcept {
  follow(X_WT, ahead);
  served_ = std::min(served_ + 1, kMostServed);
  X_WT_ = X_WT;
  X_WT_ahead_ = ToolWay{.X_WT = X_WT, .step = ahead}.at(1);
  ahead_ = ahead;
  reach_ = reach;
  return (gathering_->is_done() && covers(*gathering_)) || gather(most);
}

// How the tool moved since the last look.
void FeatureLookahead::follow(const Pose& X_WT, const Vec6& ahead) noexcept {
  Vec6 moved = Vec6::Zero();
  if (!is_first_) moved << X_WT.p - X_WT_.p, rotation_vector(X_WT.q * X_WT_.q.conjugate());
  is_first_ = false;
  const Vec6 swerved = moved - going_;
  going_ = kForgetting * going_ + (1 - kForgetting) * moved;
  swerving_ = {std::max(kForgetting * swerving_.way, swerved.head<3>().norm()),
               std::max(kForgetting * swerving_.turn, swerved.tail<3>().norm())};
  pace_ = std::max({kForgetting * pace_, length(span_of(moved)), length(span_of(ahead)) / kLooks});
  if (pace_ >= kStill) return;
  pace_ = 0;
  going_.setZero();
  swerving_ = {};
}

// Whether the gathering's candidates are all that can have come within reach, or in.
bool FeatureLookahead::covers(const FeatureGathering& gathering) noexcept {
  now_ = gathering.way().place(X_WT_, radius_);
  then_ = gathering.way().place(X_WT_ahead_, radius_);
  return gathering.covers(now_, then_, reach_);
}

// The next gathering if little is left of it to do; else what is needed at once, while the next one goes on.
bool FeatureLookahead::gather(std::size_t most) noexcept {
  if (next_->is_begun() && covers(*next_)) {
    if (!next_->is_done() && visits_left() <= at_once_visits_) {
      next_->go_on(at_once_visits_ + at_once_visits_ / 2);
      learn();
    }
    if (next_->is_done()) {
      std::swap(gathering_, next_);
      next_->give_up();
      interval_ = 0.5 * (interval_ + served_);
      served_ = 0;
      return covers(*gathering_);
    }
  }
  for (double room = room_;; room = kLeastRoom) {
    const bool is_least = !(room > kLeastRoom);
    const double turn = std::min(kMostTurn, room / radius_);
    gathering_->begin({.X_WT = X_WT_, .step = ahead_, .reach = reach_ + room, .turn = turn},
                      std::min(most, kEnough), is_least ? FeatureGathering::kAnyNumber : kEnoughVisits);
    gathering_->go_on();
    if (gathering_->is_done()) {
      at_once_visits_ = gathering_->visits();
      return covers(*gathering_);
    }
    room_ = kLeastRoom;
    if (is_least) break;
  }
  gathering_->begin({X_WT_, ahead_, reach_ + kUnmoved, kUnmoved}, most);
  gathering_->go_on();
  return gathering_->is_done() && covers(*gathering_);
}

std::size_t FeatureLookahead::visits_left() const noexcept {
  return expected_visits_ > next_->visits() ? expected_visits_ - next_->visits() : 0;
}

bool FeatureLookahead::goes_straight() const noexcept {
  return length(swerving_) < kStraight * length(span_of(going_));
}

// Where the tool will be in that many looks, as far as that can be told: there if it goes straight, else
// here.
Pose FeatureLookahead::place_in(double looks) const noexcept {
  if (!goes_straight()) return X_WT_;
  return ToolWay{.X_WT = X_WT_, .step = going_}.at(std::clamp(looks, 0.0, 2 * kLooks));
}

// Where the tool goes in that many looks from X_WT on, if it goes on as it did, and as far beside as it
// swerved.
ToolWay FeatureLookahead::way_on(const Pose& X_WT, double looks) const noexcept {
  const double on = length(span_of(going_)), room = std::max(room_, kNextRoom);
  ToolWay way{.X_WT = X_WT, .step = on > 0 ? Vec6(std::min(looks, kLongestWay / on) * going_) : Vec6::Zero()};
  const ToolWay::Place ahead = ToolWay{.X_WT = X_WT_, .step = way.step}.place(X_WT_ahead_, radius_);
  way.reach = reach_ + std::max(room, std::min(kMostSwerve, swerving_.way + ahead.off));
  way.turn = std::max(std::min(kMostTurn, room / radius_),
                      std::min({kMostTurn, kMostSwerve / radius_, swerving_.turn + ahead.turn_off}));
  return way;
}

// For how many more looks the gathering serves, at the tool's pace.
double FeatureLookahead::looks_left() const noexcept {
  if (!(pace_ > 0)) return std::numeric_limits<double>::infinity();
  const ToolWay& way = gathering_->way();
  const double beside = std::min(way.reach - reach_ - std::max(now_.off, then_.off),
                                 (way.turn - std::max(now_.turn_off, then_.turn_off)) * radius_);
  const double along = (1 - std::max(now_.part, then_.part)) * length(span_of(way.step));
  return (beside + (going_.dot(way.step) > 0 ? along : 0.0)) / pace_;
}

bool FeatureLookahead::is_on(const FeatureGathering& gathering, const Pose& X_WT) const noexcept {
  const ToolWay::Place place = gathering.way().place(X_WT, radius_);
  return gathering.covers(place, place, reach_);
}

void FeatureLookahead::go_on() noexcept {
  if (!gathering_->is_done()) return;
  const double left = looks_left();
  // It is given up where the tool neither is on its way nor comes there.
  if (next_->is_begun() && !is_on(*next_, X_WT_) && !is_on(*next_, place_in(left - 1))) next_->give_up();
  if (next_->is_done()) return;
  if (!next_->is_begun()) {
    if (left > 2 * kLooks) return;
    // From where it will be needed, if that is known, or from here.
    const double looks = goes_straight() ? kLooks : kLooks + left;
    next_->begin(way_on(place_in(left - 2), std::max(1.0, scale_ * looks)), kEnough,
                 std::max(kManyVisits, at_once_visits_ + at_once_visits_ / 2));
  }
  const auto share_of = [](std::size_t visits, double looks) {
    return static_cast<std::size_t>(static_cast<double>(visits) / std::max(1.0, looks));
  };
  next_->go_on(kLeastVisits +
               std::min(share_of(visits_left(), left - 1), share_of(2 * expected_visits_, interval_)));
  learn();
}

// What the next gathering cost so far, for those after it: how much that will be, and how far they may look.
void FeatureLookahead::learn() noexcept {
  if (next_->is_done()) {
    expected_visits_ = next_->visits() + next_->visits() / 4;
    scale_ = std::min(1.0, kGrowth * scale_);
    if (next_->visits() < kFewVisits) room_ = std::min(1.5 * room_, kMostRoom);
    if (next_->visits() > 2 * kFewVisits) room_ = std::max(room_ / 1.5, kLeastRoom);
  } else if (!next_->is_begun()) {
    scale_ = std::max(kLeastScale, 0.5 * scale_);
    room_ = std::max(kLeastRoom, 0.5 * room_);
  }
}

}  // namespace fulcrum
