#pragma once
// A tool without mass that never goes in: of all poses that keep every shell point out, the one nearest to
// where the hand wants it, in the coupling's metric: its stiffness in this tick, which its saturation makes
// smaller the farther the hand is away. The rows then push as hard as the coupling pulls and no harder. C. B.
// Zilles, J. K. Salisbury, "A constraint-based god-object method for haptic display", IROS 1995; in six axes
// M. Ortega, S. Redon, S. Coquillart, "A six degree-of-freedom god-object method for haptic display of rigid
// bodies with surface properties", IEEE TVCG 13(3), 2007.
//
// A tick is a few rounds of: linearise what is near, solve the quadratic program, go along its answer as far
// as no shell point can have passed a wall, nor an edge of the scene the tool's, look again. Points within
// reach_ of the scene are rows of the program, so that they slide along it; the others bound how far a round
// may go. Where the scene gives the surfaces' features, these are looked at in place of points: rows are the
// pairs of features that are near each other, and a tick ends where none of them has passed the other.

#include <optional>

#include "haptics/contact/elastic_qp.h"
#include "haptics/contact/feature_pairs.h"
#include "haptics/contact/friction.h"
#include "haptics/contact/query.h"
#include "haptics/contact/regions.h"
#include "haptics/motion/quasi_static_tool.h"
#include "haptics/motion/tool_motion.h"

namespace fulcrum {

class ConstrainedMotion final : public ToolMotion {
public:
  explicit ConstrainedMotion(const PlainScene& desc);

  ToolAnswer advance(const Pose& X_WG, const Twist& V_WG, std::uint32_t& faults) noexcept override;
  const BodyState& tool() const override { return tool_.state(); }
  Touching touching() const override { return regions_.touching({touching_.data(), touching_count_}); }
  double depth_max() const override { return contacts_.depth_max(); }
  double stored_energy() const noexcept override { return tool_.coupling().stored(); }
  std::vector<BuiltPart> parts() const override;

private:
  void look() noexcept;
  // The same on the triangles, see constrained_motion_features.cpp.
  void prepare_features(const PlainScene& desc);
  void look_at_features(double reach) noexcept;
  void look_for_crossings() noexcept;
  static constexpr int kFeatureRounds = 10;            // at most, in a tick
  static constexpr double kLongestPairReach = 250e-6;  // m, and at most, where there are any
  struct Rounds {
    bool settled = false, limited = false;
  };
  Rounds go_between_features(const Pose& X_WG, std::uint32_t& faults) noexcept;
  double gap_after(const FeaturePair& pair, const Vec6& step) const noexcept;
  double kept_fraction(const Vec6& step) const noexcept;
  bool take_pairs(const Vec6& step) noexcept;
  Vec6 solve_pairs(const Pose& X_WG) noexcept;
  // How much of a motion is safe, see ContactQuery::safe_fraction(); points nearer than reach_ are rows.
  double safe_fraction(double travel, double turn) const noexcept;
  // The step (6) towards the goal that the rows and friction allow; fills rows_, multipliers_ and pushing_.
  Vec6 solve(const Pose& X_WG) noexcept;
  Vec6 solve_rows(const Vec6& goal) noexcept;
  // N/m and N m/rad (6): what the coupling and the weight pull with from here, over the way to `goal`.
  Vec6 secant_metric(const Vec6& to_hand, const Vec6& goal) const noexcept;
  // The friction (6) of the points that push, under which `step` was found and then is.
  Vec6 rub_along(Vec6 step, const Vec6& friction) noexcept;
  Vec6 friction() const noexcept;
  Wrench share_force(const Wrench& coupling_F_T_W) noexcept;

  QuasiStaticTool tool_;
  CouplingDesc coupling_;
  ContactQuery query_;
  std::optional<ContactQuery> edges_;  // the scene's, against the tool
  std::optional<FeaturePairs> features_;
  std::vector<std::uint32_t> taken_;                      // of the features' pairs, those that are rows
  std::vector<bool> is_taken_;                            // (pairs)
  std::vector<std::pair<double, std::uint32_t>> broken_;  // m, and which pair
  double pair_reach_ = 0;                                 // m, of the last look
  double skin_ = 0;                                       // m, rows keep the tool this far out
  std::size_t next_face_ = 0;                             // of the tool, to be looked at for crossings
  RegionTracker regions_;
  Vec6 metric_;
  ElasticQp qp_;
  double friction_;   // coefficient
  double allowance_;  // m, see motion_allowance()
  double reach_;      // m, points nearer than this are rows
  double tool_radius_;
  Pose X_WT_before_;  // at the start of the tick
  bool looked_ = false;
  ContactQuery::Outcome outcome_;
  ContactSet contacts_;  // nearer than reach_ to the scene, at the tool's pose
  std::array<QpRow, kMaxContacts> rows_;
  std::array<double, kMaxContacts> multipliers_{};  // N
  struct Pushing {
    std::uint32_t point = 0;         // of the shell
    std::size_t contact = 0;         // in contacts_ as they were then
    double multiplier = 0;           // N
    Vec3 r_W = Vec3::Zero();         // (3) m, from T
    Vec3 friction_W = Vec3::Zero();  // (3) N
  };
  using AllPushing = std::array<Pushing, ElasticQp::kMaxActive>;
  AllPushing pushing_{};  // at the last solution, in the order of the shell
  std::size_t pushing_count_ = 0;
  std::array<Contact, kMaxContacts> touching_;
  std::array<Vec3, kMaxContacts> forces_;  // (touching x 3) N
  std::size_t touching_count_ = 0;
};

}  // namespace fulcrum
