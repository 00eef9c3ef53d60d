#include "haptics/motion/constrained_motion.h"

#include <algorithm>
#include <bit>

#include "haptics/math/number_text.h"
#include "haptics/motion/motion_limit.h"
#include "haptics/motion/query_part.h"
#include "haptics/safety/faults.h"

namespace fulcrum {
namespace {

constexpr int kMaxRounds = 6;            // at most, in a tick
constexpr double kSettledTravel = 1e-6;  // m, a round that moves no point farther ends the tick
// Over the coupling's stiffness: conflicting rows share their depth at forces that are never felt, and
// compatible ones give way by a ten thousandth of the coupling's own offset.
constexpr double kPointSlack = 1e4;

// After the shell's points, at a number that no run of either reaches across (see ContactSet).
std::uint32_t first_edge(const Pointshell& shell) {
  return static_cast<std::uint32_t>(std::bit_ceil(shell.size()));
}

std::optional<ContactQuery> edge_query(const PlainScene& desc) {
  if (!desc.scene_edges) return std::nullopt;
  const Pointshell& shell = *desc.tool_shell;
  return ContactQuery::of_scene(desc.scene_edges, desc.tool_field, Normals::of_cell, first_edge(shell),
                                shell.max_radius_m + shell.covering_radius_m);
}

// Of both fields.
template <class Figure>
double least(const PlainScene& desc, const Figure& figure) {
  const double of_scene = figure(*desc.scene_field);
  return desc.tool_field ? std::min(of_scene, figure(*desc.tool_field)) : of_scene;
}

}  // namespace

ConstrainedMotion::ConstrainedMotion(const PlainScene& desc)
    : tool_(desc, kPointSlack, std::max(desc.tool_shell->max_radius_m, kSettledTravel)),
      // Rows with other normals than the depths' own make the rounds go in circles.
      query_(desc.tool_shell, desc.scene_field, Normals::of_cell),
      edges_(edge_query(desc)),
      allowance_(least(desc, motion_allowance)),
      reach_(
          std::min(2 * allowance_, least(desc, [](const DistanceField& field) { return field.band_m(); }))) {}

ToolAnswer ConstrainedMotion::advance(const Pose& X_WG, const Twist& V_WG, std::uint32_t& faults) noexcept {
  if (!looked_) look();
  looked_ = true;
  tool_.begin(X_WG);
  bool limited = false, settled = false;
  for (int round = 0; round < kMaxRounds; ++round) {
    const Vec6 step = tool_.solve(X_WG, 0);
    const double travel = step.head<3>().norm(), turn = step.tail<3>().norm();
    const double reach = travel + turn * tool_.radius();
    settled = reach < kSettledTravel;
    if (settled) break;
    const double fraction = safe_fraction(travel, turn);
    limited = fraction < 1.0;
    if (!tool_.move(step * fraction)) {
      faults |= kNotFinite;
      break;
    }
    look();
  }
  if (!settled) tool_.solve(X_WG, 0);  // for the forces at the pose that was reached
  if (limited) faults |= kMotionLimited;
  if (!outcome_.complete) faults |= kContactsReduced;
  if (!outcome_.in_band) faults |= kToolInside;
  return tool_.settle(X_WG, V_WG, false);
}

void ConstrainedMotion::look() noexcept {
  outcome_ = query_.run(tool_.state().X_WT, tool_.contacts(), reach_);
  if (!edges_) return;
  const ContactQuery::Outcome of_edges = edges_->add(tool_.state().X_WT, tool_.contacts(), reach_);
  outcome_ = {of_edges.complete, outcome_.in_band && of_edges.in_band};
}

double ConstrainedMotion::safe_fraction(double travel, double turn) const noexcept {
  const double fraction = query_.safe_fraction(travel, turn, allowance_, reach_);
  return edges_ ? std::min(fraction, edges_->safe_fraction(travel, turn, allowance_, reach_)) : fraction;
}

std::vector<BuiltPart> ConstrainedMotion::parts() const {
  std::vector<BuiltPart> parts{
      query_part(query_),
      {"response",
       "constraint: nearest free pose in the coupling's metric, at most " + std::to_string(kMaxRounds) +
           " rounds of " + std::to_string(kMaxContacts) + " rows a tick, points within " +
           number_text(reach_ * 1e3) + " mm" + tool_.friction_note(),
       sizeof(ConstrainedMotion)},
  };
  if (edges_)
    parts.push_back(
        {"edge query", "the same of the scene's edges against the tool's field", edges_->bytes()});
  return parts;
}

}  // namespace fulcrum
