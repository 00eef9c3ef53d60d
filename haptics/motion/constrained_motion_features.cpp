// The rounds of a constrained motion on the triangles themselves. A round solves with the pairs of features
// that are near, and goes no farther than pairs are known to it. Where it turns or slides past a feature it
// may end a few micrometres in: the next round solves with the pairs as they are there, gaps below zero among
// them. What is still in after kMostMendings such rounds goes back to where it was last free, and takes
// shorter steps. What goes deeper than FeaturePairs::kDeepest in one round is no pair any more and counts as
// free: such a tool is found within kTicksToSeeAll ticks, by a look for crossings at a part of its faces in
// each, and is the fault kToolInside.

#include <algorithm>
#include <span>

#include "haptics/motion/constrained_motion.h"
#include "haptics/safety/faults.h"

namespace fulcrum {
namespace {

constexpr double kSkin = 2e-6;               // m, above what a round errs by where it turns
constexpr double kShortestReach = 50e-6;     // m, within which pairs are looked for, at least
constexpr double kLongestFreeReach = 20e-3;  // m, and at most, where there are none
constexpr double kSettledReach = 1e-6;       // m, a round that moves no point farther ends the tick
constexpr double kKept = 1e-8;               // m, a pair that a step breaks by less is kept
constexpr double kMended = 25e-6;            // m, what is in by less is left to the next round
constexpr std::size_t kPairsAtOnce = 48;
constexpr std::size_t kTicksToSeeAll = 64;  // in which all faces of the tool are looked at for crossings
constexpr int kMostMendings = 3, kMostHalvings = 6, kMostTakings = 6;

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
  outcome_.complete = complete;
}

// A tool that crosses the scene counts as inside until a look at all of its faces finds no crossing.
void ConstrainedMotion::look_for_crossings() noexcept {
  const std::size_t all = features_->faces();
  const bool whole = !looked_ || !outcome_.in_band;
  const std::size_t count = whole ? all : 1 + all / kTicksToSeeAll;
  if (next_face_ >= all) next_face_ = 0;
  outcome_.in_band = !features_->crosses(whole ? 0 : next_face_, count);
  next_face_ += count;
}

ConstrainedMotion::Rounds ConstrainedMotion::go_between_features(const Pose& X_WG,
                                                                 std::uint32_t& faults) noexcept {
  Rounds rounds;
  Pose free = tool_.state().X_WT;
  bool has_been_free = features_->least_gap() >= 0;
  double longest = kLongestFreeReach;  // m, of a step
  int mendings = 0;
  for (int round = 0; round < kFeatureRounds; ++round) {
    const Vec6 step = solve_pairs(X_WG);
    const double way = step.head<3>().norm() + step.tail<3>().norm() * tool_radius_;
    if (way < kSettledReach && features_->least_gap() >= 0) {
      rounds.settled = true;
      return rounds;
    }
    const double known = std::min(pair_reach_, longest);
    rounds.limited = way > known;
    // Enough for the next step to be as long, and no sudden multitude of pairs.
    const double most = features_->none_near() ? kLongestFreeReach : kLongestPairReach;
    const double next = std::clamp(1.25 * way, std::max(kShortestReach, 0.5 * pair_reach_),
                                   std::max(kShortestReach, std::min(4 * pair_reach_, most)));
    const Pose from = tool_.state().X_WT;
    const double deepest = std::min(-kMended, features_->least_gap() - kMended);
    const double turn = step.tail<3>().norm();
    double fraction = std::min({1.0, known / way, kept_fraction(step)});
    if (turn > FeaturePairs::kMostTurn && !features_->none_near())
      fraction = std::min(fraction, FeaturePairs::kMostTurn / turn);
    for (int halving = 0;; ++halving) {
      if (!tool_.move(step * fraction)) {
        faults |= kNotFinite;
        return rounds;
      }
      look_at_features(next);
      if (outcome_.complete && features_->least_gap() >= deepest) break;
      rounds.limited = true;
      tool_.put(from);
      if (halving == kMostHalvings) {
        look_at_features(known);
        return rounds;
      }
      fraction *= 0.5;
    }
    if (features_->least_gap() >= 0) {
      free = tool_.state().X_WT;
      has_been_free = true;
      mendings = 0;
    } else if (has_been_free && ++mendings > kMostMendings) {
      tool_.put(free);
      look_at_features(pair_reach_);
      longest = 0.25 * known;
      mendings = 0;
    }
  }
  if (has_been_free && !(features_->least_gap() >= 0)) {
    tool_.put(free);
    look_at_features(pair_reach_);
  }
  return rounds;
}

// m, the gap of a pair after the step, as the pair's plane tells it.
double ConstrainedMotion::gap_after(const FeaturePair& pair, const Vec6& step) const noexcept {
  return pair.gap + pair.nhat_W.dot(step.head<3>()) +
         (pair.p_W - tool_.state().X_WT.p).cross(pair.nhat_W).dot(step.tail<3>());
}

// 0 to 1: the part of a step that breaks no pair by more than the next round mends. The step is a solution
// over kMaxContacts rows at most, and may break pairs for which there was no room.
double ConstrainedMotion::kept_fraction(const Vec6& step) const noexcept {
  double fraction = 1;
  for (const FeaturePair& pair : features_->pairs()) {
    const double after = gap_after(pair, step);
    if (after >= std::min(0.0, pair.gap) - 0.5 * kMended) continue;
    fraction = std::min(fraction, (std::max(0.0, pair.gap) + 0.5 * kMended) / (pair.gap - after));
  }
  return fraction;
}

// Of the pairs that are no rows yet, those that the step breaks most become rows. False: it breaks none, or
// there is no room.
bool ConstrainedMotion::take_pairs(const Vec6& step) noexcept {
  const std::span<const FeaturePair> pairs = features_->pairs();
  broken_.clear();
  for (std::uint32_t i = 0; i < pairs.size(); ++i) {
    if (is_taken_[i]) continue;
    const double left = gap_after(pairs[i], step) - skin_;
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
