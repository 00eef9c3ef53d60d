#include "haptics/motion/feature_motion.h"

#include <algorithm>
#include <span>

#include "haptics/math/functions.h"
#include "haptics/math/number_text.h"
#include "haptics/safety/faults.h"

namespace fulcrum {
namespace {

constexpr int kFeatureRounds = 6;         // at most, in a tick
constexpr double kLongestReach = 250e-6;  // m, and at most, where there are any
// Over the coupling's stiffness: a row that gives way stays well within its skin while the hand is
// centimetres away.
constexpr double kFeatureSlack = 1e7;
constexpr double kThinnestSkin = 0.1e-6, kThickestSkin = 2e-6;  // m
constexpr double kShortestReach = 15e-6;     // m, within which pairs are looked for, at least
constexpr double kLongestFreeReach = 20e-3;  // m, and at most, where there are none
constexpr double kSettledReach = 1e-6;       // m, a round that moves no point farther ends the tick
constexpr double kStill = 1e-7;              // m, and one that moves none by this moves none at all
constexpr double kKept = 1e-8;               // m, a pair that a step breaks by less is kept
constexpr double kMended = 25e-6;            // m, what is in by less is left to the next round
constexpr std::size_t kPairsAtOnce = 48;
constexpr double kNearReach = 60e-6;           // m, within which all is looked at, however much it is
constexpr std::size_t kNearCandidates = 2048;  // of each kind, at most, beyond kNearReach
constexpr std::size_t kFarCandidates = 1024;   // and beyond kLongestReach
constexpr double kWider = 1.1;                 // in each tick: how fast a reach that was too wide grows again
constexpr int kMostMendings = 3, kMostHalvings = 6, kMostTakings = 6;

}  // namespace

FeatureMotion::FeatureMotion(const PlainScene& desc)
    : tool_(desc, kFeatureSlack, std::max(desc.tool_features->radius(), kSettledReach)),
      features_(desc.tool_features, desc.scene_features),
      is_taken_(FeaturePairs::kMostPairs),
      reach_(kShortestReach),
      widest_(kLongestFreeReach),
      skin_(kThinnestSkin) {
  taken_.reserve(kMaxContacts);
  broken_.reserve(FeaturePairs::kMostPairs);
  levers_W_.reserve(FeaturePairs::kMostPairs);
  look(reach_);
  crosses_ = features_.crosses();
}

ToolAnswer FeatureMotion::advance(const Pose& X_WG, const Twist& V_WG, std::uint32_t& faults) noexcept {
  if (crosses_) faults |= kToolInside;  // as the tick began, though its end may be free
  tool_.begin(X_WG);
  const Rounds rounds = go(X_WG, faults);
  look_for_crossings();
  if (!rounds.settled) solve(X_WG);  // for the forces at the pose that was reached
  if (rounds.limited) faults |= kMotionLimited;
  if (!complete_) faults |= kContactsReduced;
  if (crosses_) faults |= kToolInside;
  return tool_.settle(X_WG, V_WG);
}

void FeatureMotion::look(double reach) noexcept {
  // What is farther is looked at only while there is little of it.
  const auto sees = [&] {
    const std::size_t most = reach > kLongestReach ? kFarCandidates
                             : reach > kNearReach  ? kNearCandidates
                                                   : FeaturePairs::kMostCandidates;
    return features_.look(tool_.state().X_WT, reach, most);
  };
  for (complete_ = sees(); !complete_ && reach > kShortestReach; complete_ = sees()) {
    reach = std::max(kShortestReach, 0.25 * reach);
    widest_ = reach;
  }
  reach_ = reach;
}

// A part of the tool's faces in each tick. A tool that crosses the scene counts as inside until a look at all
// of them finds no crossing.
void FeatureMotion::look_for_crossings() noexcept {
  crosses_ = crosses_ ? features_.crosses() : features_.crosses(next_part_);
  next_part_ = (next_part_ + 1) % FeaturePairs::kParts;
}

FeatureMotion::Rounds FeatureMotion::go(const Pose& X_WG, std::uint32_t& faults) noexcept {
  Rounds rounds;
  widest_ = std::min(kWider * widest_, kLongestFreeReach);
  Pose free = tool_.state().X_WT;
  bool has_been_free = features_.least_gap() >= 0;
  double longest = kLongestFreeReach;  // m, of a step
  int mendings = 0;
  for (int round = 0; round < kFeatureRounds; ++round) {
    const Vec6 step = solve(X_WG);
    const double way = step.head<3>().norm() + step.tail<3>().norm() * tool_.radius();
    if (way < kSettledReach && features_.least_gap() >= 0) {
      rounds.settled = true;
      if (way > kStill) take_last(step);
      return rounds;
    }
    const double known = std::min(reach_, longest);
    rounds.limited = way > known;
    // Enough for the next step to be as long, no sudden multitude of pairs, and not far where there is much.
    const double most = features_.none_near() ? kLongestFreeReach : kLongestReach;
    const double wanted = std::max(0.5 * reach_, std::min({1.25 * way, 4 * reach_, most}));
    const double next = std::clamp(wanted, kShortestReach, std::max(widest_, kNearReach));
    const Pose from = tool_.state().X_WT;
    const double deepest = std::min(-kMended, features_.least_gap() - kMended);
    const double turn = step.tail<3>().norm();
    double fraction = std::min({1.0, known / way, kept_fraction(step)});
    if (turn > FeaturePairs::kMostTurn && !features_.none_near())
      fraction = std::min(fraction, FeaturePairs::kMostTurn / turn);
    for (int halving = 0;; ++halving) {
      if (!tool_.move(step * fraction)) {
        faults |= kNotFinite;
        return rounds;
      }
      // Above what a round as long errs by where it turns.
      skin_ = std::min(kThinnestSkin + math::square(fraction * turn) * tool_.radius(), kThickestSkin);
      look(next);
      if (complete_ && features_.least_gap() >= deepest) break;
      rounds.limited = true;
      tool_.put(from);
      if (halving == kMostHalvings) {
        look(known);
        return rounds;
      }
      fraction *= 0.5;
    }
    if (features_.least_gap() >= 0) {
      free = tool_.state().X_WT;
      has_been_free = true;
      mendings = 0;
    } else if (has_been_free && ++mendings > kMostMendings) {
      tool_.put(free);
      look(reach_);
      longest = 0.25 * known;
      mendings = 0;
    }
  }
  if (has_been_free && !(features_.least_gap() >= 0)) {
    tool_.put(free);
    look(reach_);
  }
  return rounds;
}

// So small a step that the forces at its beginning are those at its end.
void FeatureMotion::take_last(const Vec6& step) noexcept {
  const Pose from = tool_.state().X_WT;
  if (tool_.move(step * kept_fraction(step))) {
    look(reach_);
    if (complete_ && features_.least_gap() >= 0) return;
  }
  tool_.put(from);
  look(reach_);
}

// m, the gap of a pair after the step, as the pair's plane tells it.
double FeatureMotion::gap_after(std::size_t which, const Vec6& step) const noexcept {
  const FeaturePair& pair = features_.pairs()[which];
  return pair.gap + pair.nhat_W.dot(step.head<3>()) + levers_W_[which].dot(step.tail<3>());
}

// 0 to 1: the part of a step that breaks no pair by more than the next round mends. The step is a solution
// over kMaxContacts rows at most, and may break pairs for which there was no room.
double FeatureMotion::kept_fraction(const Vec6& step) const noexcept {
  double fraction = 1;
  for (std::size_t i = 0; i < levers_W_.size(); ++i) {
    const double gap = features_.pairs()[i].gap, after = gap_after(i, step);
    if (after >= std::min(0.0, gap) - 0.5 * kMended) continue;
    fraction = std::min(fraction, (std::max(0.0, gap) + 0.5 * kMended) / (gap - after));
  }
  return fraction;
}

// Of the pairs that are no rows yet, those that the step breaks most become rows. False: it breaks none, or
// there is no room.
bool FeatureMotion::take_pairs(const Vec6& step) noexcept {
  const std::span<const FeaturePair> pairs = features_.pairs();
  broken_.clear();
  for (std::uint32_t i = 0; i < pairs.size(); ++i) {
    if (is_taken_[i]) continue;
    const double left = gap_after(i, step) - skin_;
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
  tool_.contacts().clear();
  for (const std::uint32_t i : taken_)
    tool_.contacts().add({.point = pairs[i].number(),
                          .p_W = pairs[i].p_W,
                          .nhat_W = pairs[i].nhat_W,
                          .depth = -pairs[i].gap,
                          .overlap = {}});
  return true;
}

Vec6 FeatureMotion::solve(const Pose& X_WG) noexcept {
  taken_.clear();
  tool_.contacts().clear();
  std::fill(is_taken_.begin(), is_taken_.end(), false);
  levers_W_.clear();
  for (const FeaturePair& pair : features_.pairs())
    levers_W_.emplace_back((pair.p_W - tool_.state().X_WT.p).cross(pair.nhat_W));
  Vec6 step = tool_.to_goal(X_WG);
  for (int taking = 0; taking < kMostTakings && take_pairs(step); ++taking) step = tool_.solve(X_WG, skin_);
  if (taken_.empty()) tool_.solve(X_WG, skin_);  // nothing pushes, and nothing rubs
  return step;
}

std::vector<BuiltPart> FeatureMotion::parts() const {
  return {
      {"features", "the tool's and the scene's vertices, edges and faces themselves", features_.bytes()},
      {"response",
       "constraint: nearest free pose in the coupling's metric, at most " + std::to_string(kFeatureRounds) +
           " rounds of " + std::to_string(kMaxContacts) + " rows a tick, features within " +
           number_text(kLongestReach * 1e3) + " mm" + tool_.friction_note(),
       sizeof(FeatureMotion)},
  };
}

}  // namespace fulcrum
