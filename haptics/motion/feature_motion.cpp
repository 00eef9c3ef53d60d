#include "haptics/motion/feature_motion.h"

#include <algorithm>
#include <span>
#include <utility>

#include "haptics/math/functions.h"
#include "haptics/math/number_text.h"
#include "haptics/safety/faults.h"

namespace fulcrum {
namespace {

constexpr int kFeatureRounds = 6;  // at most, in a tick
// Over the coupling's stiffness: a row that gives way stays well within its skin while the hand is
// centimetres away.
constexpr double kFeatureSlack = 1e7;
constexpr double kThinnestSkin = 0.1e-6, kThickestSkin = 2e-6;  // m
constexpr double kNear = 60e-6;  // m, around a step that was not looked along: rows that stop it lie there
constexpr double kLongest = 250e-6;     // m, of a way that is looked along
constexpr double kLongestFree = 20e-3;  // m, and where there is nothing near
constexpr int kMostLooks = 2;           // in a round, for steps that were not looked along
constexpr double kKnown = 0.9;          // of a step: another look would not know much more
constexpr double kMuchMore = 1.5;       // of what is known: less is not worth a look once the budget is spent
constexpr std::size_t kFewPairs = 24;
constexpr double kNarrower = 0.8;  // in each tick: how fast a look beside the way becomes narrow again
constexpr int kBisections = 6;
constexpr double kSettled = 1e-6;  // m, a round that moves no point farther ends the tick
constexpr double kStill = 1e-7;    // m, and one that moves none by this moves none at all
constexpr double kKept = 1e-8;     // m, a pair that a step breaks by less is kept
constexpr double kMended = 25e-6;  // m, what is in by less is left to the next round
constexpr std::size_t kPairsAtOnce = 48;
constexpr double kWider = 1.1;  // in each tick: how fast a way that was too long grows again
constexpr int kMostMendings = 3, kMostHalvings = 6, kMostTakings = 6;

}  // namespace

FeatureMotion::FeatureMotion(const PlainScene& desc)
    : tool_(desc, kFeatureSlack, std::max(desc.tool_features->radius(), kSettled)),
      features_(desc.tool_features, desc.scene_features),
      crossings_(desc.tool_features, desc.scene_features),
      is_taken_(FeaturePairs::kMostPairs),
      longest_(kLongestFree),
      skin_(kThinnestSkin) {
  taken_.reserve(kMaxContacts);
  broken_.reserve(FeaturePairs::kMostPairs);
  levers_W_.reserve(FeaturePairs::kMostPairs);
  look(Vec6::Zero());
  crosses_ = crossings_.crosses(tool_.state().X_WT);
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
  const bool was_limited = std::exchange(was_limited_, rounds.limited);
  return tool_.settle(X_WG, V_WG, rounds.limited || was_limited);
}

double FeatureMotion::way(const Vec6& step) const noexcept {
  return step.head<3>().norm() + step.tail<3>().norm() * tool_.radius();
}

void FeatureMotion::look(const Vec6& ahead, double reach) noexcept {
  const double wanted = way(ahead), longest = longest_look();
  complete_ = features_.look(tool_.state().X_WT, wanted > longest ? Vec6(ahead * (longest / wanted)) : ahead,
                             reach, std::max(reach, around_));
  // A hand whose way is not foreseen has more looked at beside it, where there is little.
  if (reach > kReach && features_.pairs().size() < kFewPairs) around_ = std::min(2 * around_, kLongest);
}

// 0 to 1: the part of a step that stays where pairs are known.
double FeatureMotion::known_fraction(const Vec6& step) const noexcept {
  const auto is_known = [&](double fraction) {
    const Vec6 part = fraction * step;
    const double arm = math::square(tool_.radius());
    const auto product = [arm](const Vec6& a, const Vec6& b) {
      return a.head<3>().dot(b.head<3>()) + arm * a.tail<3>().dot(b.tail<3>());
    };
    const Vec6& ahead = features_.ahead();
    const double squared = product(ahead, ahead);
    const double along = squared > 0 ? std::clamp(product(part, ahead) / squared, 0.0, 1.0) : 0.0;
    return way(part - along * ahead) <= features_.reach();
  };
  if (is_known(1)) return 1;
  double known = 0, unknown = 1;
  for (int i = 0; i < kBisections; ++i) {
    const double middle = 0.5 * (known + unknown);
    (is_known(middle) ? known : unknown) = middle;
  }
  return std::max(known, std::min(1.0, features_.reach() / way(step)));
}

// Whether another look would know a good deal more of the step.
bool FeatureMotion::knows_little(const Vec6& step) const noexcept {
  const double most = std::min(1.0, longest_look() / way(step)), known = known_fraction(step);
  if (features_.is_spent() && features_.known_part(most * step) * most < kMuchMore * known) return false;
  return known < kKnown * most;
}

// m, of a way ahead.
double FeatureMotion::longest_look() const noexcept {
  return std::min(longest_, features_.none_near() ? kLongestFree : kLongest);
}

// A part of the tool's faces in each tick. A tool that crosses the scene counts as inside until a look at all
// of them finds no crossing.
void FeatureMotion::look_for_crossings() noexcept {
  const Pose& X_WT = tool_.state().X_WT;
  crosses_ = crosses_ ? crossings_.crosses(X_WT) : crossings_.crosses(X_WT, next_part_);
  next_part_ = (next_part_ + 1) % FeatureCrossings::kParts;
}

FeatureMotion::Rounds FeatureMotion::go(const Pose& X_WG, std::uint32_t& faults) noexcept {
  Rounds rounds;
  features_.begin_tick();
  longest_ = std::min(kWider * longest_, kLongestFree);
  around_ = std::max(kNarrower * around_, kReach);
  Pose free = tool_.state().X_WT;
  bool has_been_free = features_.least_gap() >= 0;
  double longest = kLongestFree;  // m, of a step
  Vec6 gone = Vec6::Zero();       // (6) m and rad, in this tick
  int mendings = 0;
  for (int round = 0; round < kFeatureRounds; ++round) {
    Vec6 step = solve(X_WG);
    if (way(step) < kSettled && features_.least_gap() >= 0) {
      rounds.settled = true;
      if (way(step) > kStill) take_last(step);
      return rounds;
    }
    for (int i = 0; i < kMostLooks && knows_little(step); ++i) {
      look(step, kNear);
      step = solve(X_WG);
    }
    const Pose from = tool_.state().X_WT;
    const double deepest = std::min(-kMended, features_.least_gap() - kMended);
    const double turn = step.tail<3>().norm(), known = known_fraction(step);
    const double most = features_.none_near() ? longest : std::min(longest, kLongest);
    double fraction = std::min({known, most / way(step), kept_fraction(step)});
    rounds.limited = known < 1 || most < way(step);
    if (turn > FeaturePairs::kMostTurn && !features_.none_near())
      fraction = std::min(fraction, FeaturePairs::kMostTurn / turn);
    // The rest of the step is the next tick's: nothing is known of it, or it would cost more than a tick has.
    if ((fraction * way(step) < kStill || (round > 0 && features_.is_spent())) &&
        features_.least_gap() >= 0) {
      rounds.limited = true;
      return rounds;
    }
    if (fraction * way(step) > kMended)
      fraction *= features_.free_part(ToolWay{.X_WT = from, .step = step}.at(fraction), 0.5 * kMended);
    for (int halving = 0;; ++halving) {
      if (!tool_.move(step * fraction)) {
        faults |= kNotFinite;
        return rounds;
      }
      // Above what a round as long errs by where it turns.
      skin_ = std::min(kThinnestSkin + math::square(fraction * turn) * tool_.radius(), kThickestSkin);
      // What is left of the step, or the tick after it, which may well go as far.
      look(fraction < 1 ? Vec6((1 - fraction) * step) : Vec6(gone + step));
      if (complete_ && features_.least_gap() >= deepest) break;
      rounds.limited = true;
      tool_.put(from);
      features_.take_back();
      if (halving == kMostHalvings) {
        look(step);
        return rounds;
      }
      fraction *= 0.5;
      longest_ = std::max(kReach, fraction * way(step));
    }
    gone += fraction * step;
    if (features_.least_gap() >= 0) {
      free = tool_.state().X_WT;
      has_been_free = true;
      mendings = 0;
    } else if (has_been_free && ++mendings > kMostMendings) {
      tool_.put(free);
      look(step);
      longest = 0.25 * fraction * way(step);
      mendings = 0;
    }
  }
  if (has_been_free && !(features_.least_gap() >= 0)) {
    tool_.put(free);
    look(gone);
  }
  return rounds;
}

// So small a step that the forces at its beginning are those at its end.
void FeatureMotion::take_last(const Vec6& step) noexcept {
  const Pose from = tool_.state().X_WT;
  const Vec6 ahead = features_.ahead();
  if (tool_.move(step * std::min(known_fraction(step), kept_fraction(step)))) {
    look(ahead);
    if (complete_ && features_.least_gap() >= 0) return;
  }
  tool_.put(from);
  look(ahead);
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
      {"features", "the tool's and the scene's vertices, edges and faces themselves",
       features_.bytes() + crossings_.bytes()},
      {"response",
       "constraint: nearest free pose in the coupling's metric, at most " + std::to_string(kFeatureRounds) +
           " rounds of " + std::to_string(kMaxContacts) + " rows a tick, features within " +
           number_text(kLongest * 1e3) + " mm, " + std::to_string(FeatureLookahead::kVisitsATick) +
           " groups of their boxes a tick" + tool_.friction_note(),
       sizeof(FeatureMotion)},
  };
}

}  // namespace fulcrum
