#pragma once
// A tool without mass that never goes in (constrained_tool.h), measured on the triangles themselves. Rows are
// the pairs of features that are near each other, and a tick ends where none of them has passed the other.
//
// A round solves with the pairs that are known: those near the way ahead, which after a tick is the way that
// this tick went. A step that goes elsewhere is looked along before it is taken, and solved for again with
// what is there; and no step goes farther than pairs are known to it, or than to where a feature would have
// gone into another on its way (feature_passing.h). Where it turns or slides past a feature it may end a few
// micrometres in: the next round solves with the pairs as they are there, gaps below zero among them. What is
// still in after kMostMendings such rounds goes back to where it was last free, and takes shorter steps. A
// tool that is in by more than FeaturePairs::kDeepest all the same, as it may be placed there, has no pairs
// that let it out, and counts as free: it is found within FeatureCrossings::kParts ticks, by a look for
// crossings at a part of its faces in each, and is the fault kToolInside.

#include <utility>
#include <vector>

#include "haptics/contact/feature_crossings.h"
#include "haptics/contact/feature_pairs.h"
#include "haptics/motion/constrained_tool.h"
#include "haptics/motion/tool_motion.h"

namespace fulcrum {

class FeatureMotion final : public ToolMotion {
public:
  explicit FeatureMotion(const PlainScene& desc);  // with the tool's features and the scene's

  ToolAnswer advance(const Pose& X_WG, const Twist& V_WG, std::uint32_t& faults) noexcept override;
  const BodyState& tool() const override { return tool_.state(); }
  Touching touching() const override { return tool_.touching(); }
  double depth_max() const override { return tool_.contacts().depth_max(); }
  double stored_energy() const noexcept override { return tool_.stored_energy(); }
  std::vector<BuiltPart> parts() const override;

private:
  struct Rounds {
    bool settled = false, limited = false;
  };
  Rounds go(const Pose& X_WG, std::uint32_t& faults) noexcept;
  static constexpr double kReach = 20e-6;  // m, around a way ahead: what is looked at there at least
  void look(const Vec6& ahead, double reach = kReach) noexcept;
  bool knows_little(const Vec6& step) const noexcept;
  double longest_look() const noexcept;
  double known_fraction(const Vec6& step) const noexcept;
  double way(const Vec6& step) const noexcept;
  void take_last(const Vec6& step) noexcept;
  void look_for_crossings() noexcept;
  double gap_after(std::size_t which, const Vec6& step) const noexcept;
  double kept_fraction(const Vec6& step) const noexcept;
  bool take_pairs(const Vec6& step) noexcept;
  Vec6 solve(const Pose& X_WG) noexcept;

  ConstrainedTool tool_;
  FeaturePairs features_;
  FeatureCrossings crossings_;
  std::vector<std::uint32_t> taken_;  // of the pairs, those that are rows
  std::vector<bool> is_taken_;        // (pairs)
  std::vector<Vec3> levers_W_;        // (pairs x 3) m, (p - p_T) x nhat: how a turn opens it
  std::vector<std::pair<double, std::uint32_t>> broken_;  // m, and which pair
  double around_ = kReach;                                // m, there was little so far around
  double longest_;                                        // m, a step as long went in too deep
  double skin_;                                           // m, rows keep the tool this far out
  unsigned next_part_ = 0;                                // of the tool, to be looked at for crossings
  bool complete_ = true;                                  // the last look had room for all that was near
  bool was_limited_ = false;                              // in the tick before
  bool crosses_ = false;                                  // as far as it is known
};

}  // namespace fulcrum
