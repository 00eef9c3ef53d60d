// The rounds of a constrained motion on the triangles themselves. A round solves with the pairs of features
// that are near, goes no farther than pairs are known to it, and is halved while the surfaces would cross
// where it ends, or while there are more pairs than fit. What the tool goes into and out of again within one
// such step, at most the reach below, is not seen. No depth is measured here: the one that is told is 0, and
// a tool that crosses the scene is the fault kToolInside.

#include <algorithm>
#include <span>

#include "haptics/motion/constrained_motion.h"
#include "haptics/safety/faults.h"

namespace fulcrum {
namespace {

constexpr double kSkin = 2e-6;               // m, above what a round errs by where it turns
constexpr double kShortestReach = 50e-6;     // m, within which pairs are looked for, at least
constexpr double kLongestReach = 250e-6;     // m, and at most, where there are any
constexpr double kLongestFreeReach = 20e-3;  // m, and at most, where there are none
constexpr double kSettledReach = 1e-6;       // m, a round that moves no point farther ends the tick
constexpr double kKept = 1e-8;               // m, a pair that a step breaks by less is kept
constexpr std::size_t kPairsAtOnce = 48;
constexpr int kMostRounds = 8, kMostHalvings = 6, kMostTakings = 6;

}  // namespace

void ConstrainedMotion::prepare_features(const PlainScene& desc) {
  features_.emplace(desc.tool_features, desc.scene_features);
  taken_.reserve(kMaxContacts);
  is_taken_.resize(FeaturePairs::kMostPairs);
  broken_.reserve(FeaturePairs::kMostPairs);
  pair_reach_ = kShortestReach;
  skin_ = kSkin;
  tool_radius_ = std::max(desc.tool_features->radius(), kSettledReach);
}

void ConstrainedMotion::look_at_features(double reach) noexcept {
  bool complete = features_->look(tool_.state().X_WT, reach);
  while (!complete && reach > kShortestReach) {
    reach = std::max(kShortestReach, 0.5 * reach);
    complete = features_->look(tool_.state().X_WT, reach);
  }
  pair_reach_ = reach;
  outcome_ = {complete, !features_->crosses()};
}

ConstrainedMotion::Rounds ConstrainedMotion::go_between_features(const Pose& X_WG,
                                                                 std::uint32_t& faults) noexcept {
  Rounds rounds;
  const bool crossed = features_->crosses();  // it began inside, and is let out
  for (int round = 0; round < kMostRounds; ++round) {
    const Vec6 step = solve_pairs(X_WG);
    const double way = step.head<3>().norm() + step.tail<3>().norm() * tool_radius_;
    rounds.settled = way < kSettledReach;
    if (rounds.settled) return rounds;
    const double known = pair_reach_;
    rounds.limited = way > known;
    // Enough for the next step to be as long, and no sudden multitude of pairs.
    const double most = features_->none_near() ? kLongestFreeReach : kLongestReach;
    const double next = std::clamp(2 * way, std::max(kShortestReach, 0.5 * known),
                                   std::max(kShortestReach, std::min(4 * known, most)));
    const Pose from = tool_.state().X_WT;
    double fraction = std::min(1.0, known / way);
    for (int halving = 0;; ++halving) {
      if (!tool_.move(step * fraction)) {
        faults |= kNotFinite;
        return rounds;
      }
      look_at_features(next);
      if (crossed || (outcome_.complete && !features_->crosses())) break;
      rounds.limited = true;
      tool_.put(from);
      if (halving == kMostHalvings) {
        look_at_features(known);
        return rounds;
      }
      fraction *= 0.5;
    }
  }
  return rounds;
}

// Of the pairs that are no rows yet, those that the step breaks most become rows. False: it breaks none, or
// there is no room.
bool ConstrainedMotion::take_pairs(const Vec6& step) noexcept {
  const std::span<const FeaturePair> pairs = features_->pairs();
  const Vec3& p_WT = tool_.state().X_WT.p;
  broken_.clear();
  for (std::uint32_t i = 0; i < pairs.size(); ++i) {
    if (is_taken_[i]) continue;
    const Vec3& nhat_W = pairs[i].nhat_W;
    const double left = pairs[i].gap - skin_ + nhat_W.dot(step.head<3>()) +
                        (pairs[i].p_W - p_WT).cross(nhat_W).dot(step.tail<3>());
    if (left < -kKept) broken_.emplace_back(left, i);
  }
  const std::size_t count = std::min({kPairsAtOnce, broken_.size(), kMaxContacts - taken_.size()});
  if (count == 0) return false;
  std::partial_sort(broken_.begin(), broken_.begin() + static_cast<std::ptrdiff_t>(count), broken_.end());
  for (const auto& [left, i] : std::span(broken_).first(count)) {
    is_taken_[i] = true;
    taken_.push_back(i);
  }
  std::sort(taken_.begin(), taken_.end(), [&](std::uint32_t l, std::uint32_t r) {
    return pairs[l].number() < pairs[r].number() || (pairs[l].number() == pairs[r].number() && l < r);
  });
  contacts_.clear();
  for (const std::uint32_t i : taken_)
    contacts_.add({.point = pairs[i].number(),
                   .p_W = pairs[i].p_W,
                   .nhat_W = pairs[i].nhat_W,
                   .depth = -pairs[i].gap,
                   .overlap = {}});
  return true;
}

Vec6 ConstrainedMotion::solve_pairs(const Pose& X_WG) noexcept {
  taken_.clear();
  contacts_.clear();
  std::fill(is_taken_.begin(), is_taken_.end(), false);
  Vec6 step = tool_.to_goal(X_WG);
  for (int taking = 0; taking < kMostTakings && take_pairs(step); ++taking) step = solve(X_WG);
  return step;
}

}  // namespace fulcrum
