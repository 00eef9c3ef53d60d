#pragma once
// What the constrained motions share: of all poses that keep every row of contact out, the one nearest to
// where the hand wants the tool, in the coupling's metric: its stiffness in this tick, which its saturation
// makes smaller the farther the hand is away. The rows then push as hard as the coupling pulls and no harder.
// C. B. Zilles, J. K. Salisbury, "A constraint-based god-object method for haptic display", IROS 1995; in six
// axes M. Ortega, S. Redon, S. Coquillart, "A six degree-of-freedom god-object method for haptic display of
// rigid bodies with surface properties", IEEE TVCG 13(3), 2007.

#include <array>
#include <string>

#include "haptics/contact/contact_set.h"
#include "haptics/contact/elastic_qp.h"
#include "haptics/contact/friction.h"
#include "haptics/contact/regions.h"
#include "haptics/motion/quasi_static_tool.h"
#include "haptics/tick/tool_answer.h"

namespace fulcrum {

class ConstrainedTool {
public:
  // slack: over the coupling's stiffness, of rows that conflict and share their depth. radius m: the tool's
  // reach from T.
  ConstrainedTool(const PlainScene& desc, double slack, double radius);

  const BodyState& state() const { return tool_.state(); }
  double radius() const { return radius_; }
  double stored_energy() const noexcept { return tool_.coupling().stored(); }

  // A tick begins: its metric, and the pose that slip is told from.
  void begin(const Pose& X_WG) noexcept;
  // (6) m and rad in W, about T: to where coupling and weight alone would have it.
  Vec6 to_goal(const Pose& X_WG) noexcept { return tool_.to_goal(X_WG); }
  bool move(const Vec6& d) noexcept { return tool_.move(d); }
  void put(const Pose& X_WT) noexcept { tool_.put(X_WT); }

  // What may be rows, at the tool's pose; in the order of their numbers, by which they are known again from
  // tick to tick. Whoever moves the tool fills it.
  ContactSet& contacts() { return contacts_; }
  const ContactSet& contacts() const { return contacts_; }
  // The step (6) towards the goal that the contacts and friction allow. skin m: rows keep the tool this far
  // out.
  Vec6 solve(const Pose& X_WG, double skin) noexcept;

  // The tick's last word, once solve() has been at the pose that was reached. is_late: as of QuasiStaticTool.
  ToolAnswer settle(const Pose& X_WG, const Twist& V_WG, bool is_late) noexcept;
  // As settle() left it.
  Touching touching() const { return regions_.touching({touching_.data(), touching_count_}); }

  std::string friction_note() const { return fulcrum::friction_note(contact_); }

private:
  Vec6 solve_rows(const Vec6& goal) noexcept;
  // N/m and N m/rad (6): what the coupling and the weight pull with from here, over the way to `goal`.
  Vec6 secant_metric(const Vec6& to_hand, const Vec6& goal) const noexcept;
  // The friction (6) of the points that push, under which `step` was found and then is.
  Vec6 rub_along(Vec6 step, const Vec6& friction) noexcept;
  Vec6 friction() const noexcept;
  Wrench share_force(const Wrench& coupling_F_T_W) noexcept;

  QuasiStaticTool tool_;
  CouplingDesc coupling_;
  RegionTracker regions_;
  Vec6 metric_;
  ElasticQp qp_;
  ContactDesc contact_;
  double radius_;
  Pose X_WT_before_;  // at the start of the tick
  ContactSet contacts_;
  std::array<QpRow, kMaxContacts> rows_;
  std::array<double, kMaxContacts> multipliers_{};  // N
  struct Pushing {
    std::uint32_t point = 0;                // its number
    std::size_t contact = 0;                // in contacts_ as they were then
    double multiplier = 0;                  // N
    Vec3 r_W = Vec3::Zero();                // (3) m, from T
    Vec3 friction_W = Vec3::Zero();         // (3) N
    Vec3 friction_torque_W = Vec3::Zero();  // (3) N m
  };
  using AllPushing = std::array<Pushing, ElasticQp::kMaxActive>;
  AllPushing pushing_{};  // at the last solution, in the order of their numbers
  std::size_t pushing_count_ = 0;
  std::array<Contact, kMaxContacts> touching_;
  std::array<Vec3, kMaxContacts> forces_;  // (touching x 3) N
  std::size_t touching_count_ = 0;
};

}  // namespace fulcrum
