#include "haptics/contact/feature_lookahead.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

constexpr double kUnmoved = 1e-8;      // m and rad, around a look that must do with what is in
constexpr double kStill = 1e-12;       // m, a slower tool stands still
constexpr double kLeastReach = 20e-6;  // m, around what is ahead: where there is less the tool does not go
constexpr double kLeastRoom = 50e-6;   // m, beyond what a look asks for
constexpr double kMostRoom = 2e-3;     // m, likewise, where there is little
// How far beside its way a tool that swerves is looked for, and how far along it.
constexpr double kMostSwerve = 250e-6;  // m
constexpr double kMostTurn = 0.1;       // rad
constexpr double kLongestWay = 2e-3;    // m
constexpr double kLooks = 8;            // that a gathering is for, and that the next one has time for
constexpr double kStraight = 0.25;      // of how far the tool goes: who swerves by less goes straight
constexpr double kForgetting = 0.75;    // of how the tool moved, in each look
// How far ahead the next one looks: half as far after one that was too much, and then a little farther again.
constexpr double kLeastScale = 0.1, kGrowth = 1.1;
constexpr double kLeastNeededScale = 1e-3;
constexpr double kWorth = 0.5;              // of a look: who knows more needs no other gathering at once
constexpr std::size_t kEnough = 6144;       // candidates of a kind, not needed yet: more are too much
constexpr std::size_t kManyVisits = 12288;  // of a gathering that was not needed yet: more are too much
constexpr std::size_t kFewVisits = 384;     // so little may be gathered from farther around the next time
constexpr std::size_t kLeastVisits = 96;    // in a share
constexpr double kMostServed = 100;         // looks: a gathering that served for more tells of no more haste
constexpr int kBisections = 6;

}  // namespace

FeatureLookahead::FeatureLookahead(const FeatureMesh& tool_T, const FeatureMesh& scene_W, double slack,
                                   double deepest)
    : radius_(tool_T.radius()),
      deepest_(deepest),
      gathering_(std::make_unique<FeatureGathering>(tool_T, scene_W, slack, deepest)),
      next_(std::make_unique<FeatureGathering>(tool_T, scene_W, slack, deepest)),
      room_(kLeastRoom) {}

FeatureLookahead::Known FeatureLookahead::look(const Pose& X_WT, const Vec6& ahead, double reach,
                                               double farthest) noexcept {
  follow(X_WT, ahead);
  served_ = std::min(served_ + 1, kMostServed);
  X_WT_ = X_WT;
  ahead_ = ahead;
  reach_ = reach;
  Known result = known(*gathering_);
  if (!is_all(result)) {
    find_more();
    result = known(*gathering_);
  }
  if (result.reach < 0) {
    // What is in here has to be known.
    const std::size_t budget = std::exchange(budget_, FeatureGathering::kAnyNumber);
    find_more();
    result = known(*gathering_);
    budget_ = budget == FeatureGathering::kAnyNumber ? budget : 0;
  }
  result = known(*gathering_, ahead_, farthest);
  now_ = gathering_->way().place(X_WT_, radius_);
  then_ = gathering_->way().place(ToolWay{.X_WT = X_WT_, .step = ahead_}.at(result.part), radius_);
  return result;
}

// m^2, of two steps.
double FeatureLookahead::product(const Vec6& a, const Vec6& b) const noexcept {
  return a.head<3>().dot(b.head<3>()) + radius_ * radius_ * a.tail<3>().dot(b.tail<3>());
}

// How the tool moved since the last look.
void FeatureLookahead::follow(const Pose& X_WT, const Vec6& ahead) noexcept {
  Vec6 moved = Vec6::Zero();
  if (!is_first_) moved << X_WT.p - X_WT_.p, rotation_vector(X_WT.q * X_WT_.q.conjugate());
  is_first_ = false;
  // Beside how it went: who goes on more slowly, or faster, goes straight.
  const double squared = product(going_, going_);
  const Vec6 swerved = moved - (squared > 0 ? std::max(0.0, product(moved, going_) / squared) : 0.0) * going_;
  going_ = kForgetting * going_ + (1 - kForgetting) * moved;
  swerving_ = {std::max(kForgetting * swerving_.way, swerved.head<3>().norm()),
               std::max(kForgetting * swerving_.turn, swerved.tail<3>().norm())};
  pace_ = std::max({kForgetting * pace_, length(span_of(moved)), length(span_of(ahead)) / kLooks});
  if (pace_ >= kStill) return;
  pace_ = 0;
  going_.setZero();
  swerving_ = {};
}

// m: how far the tool may go from X_WT, in any way, while the gathering has all that is in. Below 0: it has
// not even what is in there.
double FeatureLookahead::spare(const FeatureGathering& gathering, const Pose& X_WT) const noexcept {
  const ToolWay::Place place = gathering.way().place(X_WT, radius_);
  return std::min(gathering.way().reach - deepest_ - place.off,
                  (gathering.way().turn - place.turn_off) * radius_);
}

FeatureLookahead::Known FeatureLookahead::known(const FeatureGathering& gathering, const Vec6& ahead,
                                                double reach) const noexcept {
  if (!gathering.is_done()) return {};
  const ToolWay step{.X_WT = X_WT_, .step = ahead};
  const double here = spare(gathering, X_WT_);
  double least = std::min(reach, kLeastReach);
  if (here < least) return {.part = 0, .reach = here};
  // Who does not go straight needs to know as much beside the step as along it.
  if (!foresees()) least = std::max(least, 0.5 * std::min(here, reach));
  double part = 1, there = spare(gathering, step.at(1));
  if (there < least) {
    double unknown = 1;
    part = 0;
    there = here;
    for (int i = 0; i < kBisections; ++i) {
      const double middle = 0.5 * (part + unknown), spare_then = spare(gathering, step.at(middle));
      if (spare_then < least) {
        unknown = middle;
      } else {
        part = middle;
        there = spare_then;
      }
    }
  }
  return {part, std::min({reach, here, there})};
}

double FeatureLookahead::known_part(const Vec6& ahead) const noexcept {
  return known(*gathering_, ahead, kLeastReach).part;
}

// m, of a way that may be gone.
double FeatureLookahead::length(const Known& known) const noexcept {
  return known.reach < 0 ? -1 : known.part * length(span_of(ahead_)) + known.reach;
}

// A gathering that knows more of this look, as far as the budget goes: the next one if it will do here, else
// one that begins here.
void FeatureLookahead::find_more() noexcept {
  if (next_->is_begun() && spare(*next_, X_WT_) >= std::min(reach_, kLeastReach)) {
    grow(budget_);
    if (next_->is_begun() && !next_->is_done()) return;
    if (next_->is_done()) take_next();
  }
  const double ahead = length(span_of(ahead_));
  const double most = reach_ + (foresees() ? ahead : std::min(ahead, room_));
  if (in_tick_ && length(known(*gathering_)) > kWorth * most) return;
  for (is_needed_ = true;;) {
    const bool is_least = needed_scale_ < kLeastNeededScale;
    next_->begin(way_here(is_least ? 0 : needed_scale_), FeatureGathering::kMostCandidates);
    grow(budget_);
    if (next_->is_done()) return take_next();
    if (next_->is_begun() || is_least) return;
  }
}

// It serves, if it knows more of this look.
void FeatureLookahead::take_next() noexcept {
  if (length(known(*next_)) > length(known(*gathering_))) {
    std::swap(gathering_, next_);
    interval_ = 0.5 * (interval_ + served_);
    served_ = 0;
  }
  next_->give_up();
}

// More of the next gathering. What it cost tells those after it how much that will be, and how far they may
// look.
void FeatureLookahead::grow(std::size_t visits) noexcept {
  if (next_->is_done()) return;
  const std::size_t before = next_->visits();
  next_->go_on(std::min(visits, budget_));
  if (budget_ != FeatureGathering::kAnyNumber) budget_ -= std::min(budget_, next_->visits() - before);
  double& scale = is_needed_ ? needed_scale_ : scale_;
  if (next_->is_done()) {
    scale = std::min(1.0, kGrowth * scale);
    (is_needed_ ? needed_visits_ : expected_visits_) = next_->visits() + next_->visits() / 4;
    if (next_->visits() < kFewVisits) room_ = std::min(1.5 * room_, kMostRoom);
    if (next_->visits() > 2 * kFewVisits) room_ = std::max(room_ / 1.5, kLeastRoom);
  } else if (!next_->is_begun()) {
    scale = std::max(0.5 * scale, is_needed_ ? 0.5 * kLeastNeededScale : kLeastScale);
    room_ = std::max(kLeastRoom, 0.5 * room_);
  }
}

std::size_t FeatureLookahead::visits_left() const noexcept {
  return expected_visits_ > next_->visits() ? expected_visits_ - next_->visits() : 0;
}

bool FeatureLookahead::goes_straight() const noexcept {
  return length(swerving_) < kStraight * length(span_of(going_));
}

// Whether what a look asks for ahead is likely to be where the tool goes.
bool FeatureLookahead::foresees() const noexcept {
  return !in_tick_ || goes_straight();
}

// Where the tool will be in that many looks, as far as that can be told: there if it goes straight, else
// here.
Pose FeatureLookahead::place_in(double looks) const noexcept {
  if (!goes_straight()) return X_WT_;
  return ToolWay{.X_WT = X_WT_, .step = going_}.at(std::clamp(looks, 0.0, 2 * kLooks));
}

// What this look asks for, and some room around; and if the tool goes straight what the next ones will.
ToolWay FeatureLookahead::way_here(double scale) const noexcept {
  const double around = scale * (reach_ + room_) + kUnmoved;
  ToolWay way{.X_WT = X_WT_, .step = Vec6::Zero(), .reach = deepest_ + around, .turn = turn_of(around)};
  const double length = this->length(span_of(ahead_));
  if (!foresees() || !(length > 0)) return way;
  way.step = scale * std::max(1.0, std::min(kLongestWay, 2 * kLooks * pace_) / length) * ahead_;
  return way;
}

// rad: as far as the tool turns about its origin where none of it goes farther, or as far as is looked.
double FeatureLookahead::turn_of(double around) const noexcept {
  return std::max(std::min(reach_, around) / radius_, std::min(kMostTurn, around / radius_));
}

// Where the tool goes in that many looks from X_WT on, if it goes on as it did, as fast as it did lately, and
// as far beside as it swerved.
ToolWay FeatureLookahead::way_on(const Pose& X_WT, double looks) const noexcept {
  const double on = length(span_of(going_));
  ToolWay way{.X_WT = X_WT, .step = Vec6::Zero()};
  if (on > 0)
    way.step = std::min(looks * std::max(on, goes_straight() ? pace_ : 0.0), kLongestWay) / on * going_;
  const ToolWay::Place ahead =
      ToolWay{.X_WT = X_WT_, .step = way.step}.place(ToolWay{.X_WT = X_WT_, .step = ahead_}.at(1), radius_);
  way.reach = deepest_ + reach_ + std::max(room_, std::min(kMostSwerve, swerving_.way + ahead.off));
  way.turn = std::max(turn_of(reach_ + room_),
                      std::min({kMostTurn, kMostSwerve / radius_, swerving_.turn + ahead.turn_off}));
  return way;
}

// For how many more looks the gathering serves, at the tool's pace.
double FeatureLookahead::looks_left() const noexcept {
  if (!(pace_ > 0)) return std::numeric_limits<double>::infinity();
  const ToolWay& way = gathering_->way();
  const double beside = std::min(way.reach - deepest_ - std::max(now_.off, then_.off),
                                 (way.turn - std::max(now_.turn_off, then_.turn_off)) * radius_) -
                        std::min(reach_, kLeastReach);
  const double along = (1 - std::max(now_.part, then_.part)) * length(span_of(way.step));
  return (beside + (going_.dot(way.step) > 0 ? along : 0.0)) / pace_;
}

void FeatureLookahead::go_on() noexcept {
  if (!gathering_->is_done()) return;
  const double left = looks_left();
  // It is given up where the tool neither is on its way nor comes there.
  if (next_->is_begun() && spare(*next_, X_WT_) < 0 && spare(*next_, place_in(left - 1)) < 0)
    next_->give_up();
  if (next_->is_done()) return;
  if (!next_->is_begun()) {
    const double needs = static_cast<double>(expected_visits_) / static_cast<double>(kVisitsATick);
    if (left > 2 * kLooks + needs) return;
    // From where it will be needed, if that is known, or from here.
    const double looks = goes_straight() ? std::max(kLooks, 2 * needs) : kLooks + left;
    is_needed_ = false;
    next_->begin(way_on(place_in(left - 2), std::max(1.0, scale_ * looks)), kEnough,
                 std::max(kManyVisits, 2 * needed_visits_));
  }
  const auto share_of = [](std::size_t visits, double looks) {
    return static_cast<std::size_t>(static_cast<double>(visits) / std::max(1.0, looks));
  };
  grow(kLeastVisits + std::min(share_of(visits_left(), left - 1), share_of(2 * expected_visits_, interval_)));
}

}  // namespace fulcrum
