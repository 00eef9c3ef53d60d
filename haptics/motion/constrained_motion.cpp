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
constexpr int kPasses = 3;               // in which normal forces and friction find each other
constexpr double kSettledTravel = 1e-6;  // m, a round that moves no point farther ends the tick
constexpr double kTouching = 50e-6;      // m, a point nearer than this belongs to a region
constexpr double kSettledTurn = 1e-6;    // rad, the same of a turn
constexpr double kSoftestShare = 1e-4;   // of the coupling's stiffness, however far the hand is away
// Over the coupling's stiffness: conflicting rows share their depth at forces that are never felt, and
// compatible ones give way by a ten thousandth of the coupling's own offset.
constexpr double kSlackStiffness = 1e4;
// The same on features, where a row that gives way has to stay well within its skin of 2 um while the hand is
// centimetres away.
constexpr double kSlackStiffnessOfFeatures = 1e7;

Vec6 metric(const CouplingDesc& coupling) {
  Vec6 m;
  m.head<3>().setConstant(coupling.stiffness);
  m.tail<3>().setConstant(coupling.angular_stiffness);
  return m;
}

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
    : tool_(desc),
      coupling_(desc.coupling),
      // Rows with other normals than the depths' own make the rounds go in circles.
      query_(desc.tool_shell, desc.scene_field, Normals::of_cell),
      edges_(edge_query(desc)),
      regions_(desc.contact.region_radius),
      metric_(metric(desc.coupling)),
      qp_(metric_,
          (desc.tool_features ? kSlackStiffnessOfFeatures : kSlackStiffness) * desc.coupling.stiffness),
      friction_(desc.contact.friction),
      allowance_(least(desc, motion_allowance)),
      reach_(
          std::min(2 * allowance_, least(desc, [](const DistanceField& field) { return field.band_m(); }))),
      tool_radius_(std::max(desc.tool_shell->max_radius_m, kSettledTravel)) {
  if (!desc.tool_features) return;
  prepare_features(desc);
}

ToolAnswer ConstrainedMotion::advance(const Pose& X_WG, const Twist& V_WG, std::uint32_t& faults) noexcept {
  if (!looked_) {
    features_ ? look_at_features(pair_reach_) : look();
    if (features_) look_for_crossings();
  }
  looked_ = true;
  X_WT_before_ = tool_.state().X_WT;
  metric_ = secant_metric(tool_.to_hand(X_WG), tool_.to_goal(X_WG));
  qp_.set_metric(metric_);
  bool limited = false, settled = false;
  if (features_) {
    if (!outcome_.in_band) faults |= kToolInside;  // as the tick began, though its end may be free
    const Rounds rounds = go_between_features(X_WG, faults);
    limited = rounds.limited;
    settled = rounds.settled;
    look_for_crossings();
  }
  for (int round = 0; !features_ && round < kMaxRounds; ++round) {
    const Vec6 step = solve(X_WG);
    const double travel = step.head<3>().norm(), turn = step.tail<3>().norm();
    const double reach = travel + turn * tool_radius_;
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
  if (!settled) features_ ? solve_pairs(X_WG) : solve(X_WG);  // for the forces at the pose that was reached
  if (limited) faults |= kMotionLimited;
  if (!outcome_.complete) faults |= kContactsReduced;
  if (!outcome_.in_band) faults |= kToolInside;

  ToolAnswer answer;
  answer.X_WT = tool_.state().X_WT;
  answer.coupling_F_T_W = tool_.settle(X_WG, V_WG);
  answer.full_torque_T_W = tool_.coupling().full_torque();
  answer.turn_W = tool_.coupling().turn();
  answer.contact_F_T_W = share_force(answer.coupling_F_T_W);
  return answer;
}

void ConstrainedMotion::look() noexcept {
  outcome_ = query_.run(tool_.state().X_WT, contacts_, reach_);
  if (!edges_) return;
  const ContactQuery::Outcome of_edges = edges_->add(tool_.state().X_WT, contacts_, reach_);
  outcome_ = {of_edges.complete, outcome_.in_band && of_edges.in_band};
}

double ConstrainedMotion::safe_fraction(double travel, double turn) const noexcept {
  const double fraction = query_.safe_fraction(travel, turn, allowance_, reach_);
  return edges_ ? std::min(fraction, edges_->safe_fraction(travel, turn, allowance_, reach_)) : fraction;
}

Vec6 ConstrainedMotion::solve(const Pose& X_WG) noexcept {
  const std::span<const Contact> contacts = contacts_.contacts();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    rows_[i].a << contacts[i].nhat_W, Vec3(contacts[i].p_W - tool_.state().X_WT.p).cross(contacts[i].nhat_W);
    rows_[i].b = contacts[i].depth + skin_;
  }
  const Vec6 goal = tool_.to_goal(X_WG);
  if (friction_ == 0.0) return solve_rows(goal);
  // Rows have the last word: friction never pushes a point in.
  Vec6 rubbing = friction();
  for (int pass = 0; pass < kPasses; ++pass)
    rubbing = rub_along(solve_rows(goal + rubbing.cwiseQuotient(metric_)), rubbing);
  return solve_rows(goal + rubbing.cwiseQuotient(metric_));
}

Vec6 ConstrainedMotion::secant_metric(const Vec6& to_hand, const Vec6& goal) const noexcept {
  Vec3 pull = saturated_spring(to_hand.head<3>(), coupling_.stiffness, coupling_.max_force);
  pull.y() -= tool_.weight();
  const Vec3 twist = saturated_spring(goal.tail<3>(), coupling_.angular_stiffness, coupling_.max_torque);
  const double way = goal.head<3>().norm(), turn = goal.tail<3>().norm();
  CouplingDesc secant = coupling_;
  if (way > kSettledTravel)
    secant.stiffness =
        std::clamp(pull.norm() / way, kSoftestShare * coupling_.stiffness, coupling_.stiffness);
  if (turn > kSettledTurn)
    secant.angular_stiffness = std::max(twist.norm() / turn, kSoftestShare * coupling_.angular_stiffness);
  return metric(secant);
}

Vec6 ConstrainedMotion::solve_rows(const Vec6& goal) noexcept {
  const std::span<const Contact> contacts = contacts_.contacts();
  // The points that pushed last are the best guess at those that will.
  const AllPushing before = pushing_;
  const std::size_t before_count = pushing_count_;
  std::size_t next = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    while (next < before_count && before[next].point < contacts[i].point) ++next;
    const bool pushed = next < before_count && before[next].point == contacts[i].point;
    multipliers_[i] = pushed ? before[next].multiplier : 0.0;
  }
  Vec6 step = qp_.solve(goal, {rows_.data(), contacts.size()}, {multipliers_.data(), contacts.size()}).x;
  pushing_count_ = next = 0;
  for (std::size_t i = 0; i < contacts.size() && pushing_count_ < pushing_.size(); ++i) {
    if (!(multipliers_[i] > 0)) continue;
    while (next < before_count && before[next].point < contacts[i].point) ++next;
    const bool pushed = next < before_count && before[next].point == contacts[i].point;
    pushing_[pushing_count_++] = {.point = contacts[i].point,
                                  .contact = i,
                                  .multiplier = multipliers_[i],
                                  .r_W = contacts[i].p_W - tool_.state().X_WT.p,
                                  .friction_W = pushed ? before[next].friction_W : Vec3(Vec3::Zero())};
  }
  return step;
}

Vec6 ConstrainedMotion::friction() const noexcept {
  Vec6 sum = Vec6::Zero();
  for (std::size_t i = 0; i < pushing_count_; ++i) {
    sum.head<3>() += pushing_[i].friction_W;
    sum.tail<3>() += pushing_[i].r_W.cross(pushing_[i].friction_W);
  }
  return sum;
}

Vec6 ConstrainedMotion::rub_along(Vec6 step, const Vec6& under) noexcept {
  const Pose& X_WT = tool_.state().X_WT;
  std::array<RubbingPoint, ElasticQp::kMaxActive> points;
  for (std::size_t i = 0; i < pushing_count_; ++i) {
    const Contact& contact = contacts_.contacts()[pushing_[i].contact];
    const Vec3 p_T = X_WT.inverse() * contact.p_W;
    points[i] = {.nhat_W = contact.nhat_W,
                 .r_W = pushing_[i].r_W,
                 .slip_W = contact.p_W - X_WT_before_ * p_T,
                 .normal_force = pushing_[i].multiplier,
                 .force_W = pushing_[i].friction_W};
  }
  // Points that no longer push no longer rub.
  step += (friction() - under).cwiseQuotient(metric_);
  Vec6 now = rub(metric_, friction_, step, {points.data(), pushing_count_});
  for (std::size_t i = 0; i < pushing_count_; ++i) pushing_[i].friction_W = points[i].force_W;
  return now;
}

// The tool has no mass: what the coupling and the weight leave over, the scene gives. The rows' forces tell
// how it is shared out; where the coupling's spring saturates they are larger than what is felt.
Wrench ConstrainedMotion::share_force(const Wrench& coupling_F_T_W) noexcept {
  const std::span<const Contact> contacts = contacts_.contacts();
  Wrench rows_F_T_W;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    rows_F_T_W.force += multipliers_[i] * rows_[i].a.head<3>();
    rows_F_T_W.torque += multipliers_[i] * rows_[i].a.tail<3>();
  }
  const Vec6 rubbing = friction();
  rows_F_T_W += {rubbing.head<3>(), rubbing.tail<3>()};
  Wrench contact_F_T_W;
  if (!rows_F_T_W.is_zero()) {
    contact_F_T_W = -coupling_F_T_W;
    contact_F_T_W.force.y() += tool_.weight();
  }
  // By least squares over the whole wrench: a pure couple has no force to compare. Torque counts by the force
  // that it takes at the tool's reach.
  const double arm = 1.0 / (tool_radius_ * tool_radius_);
  const auto product = [arm](const Wrench& a, const Wrench& b) {
    return a.force.dot(b.force) + arm * a.torque.dot(b.torque);
  };
  const double by_rows = product(rows_F_T_W, rows_F_T_W);
  const double felt = by_rows > 0 ? std::max(0.0, product(contact_F_T_W, rows_F_T_W) / by_rows) : 0.0;
  touching_count_ = 0;
  std::size_t next = 0;
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    if (multipliers_[i] == 0.0 && contacts[i].depth < -kTouching) continue;
    const bool rubs = next < pushing_count_ && pushing_[next].contact == i;
    const Vec3 friction_W = rubs ? pushing_[next++].friction_W : Vec3(Vec3::Zero());
    touching_[touching_count_] = contacts[i];
    forces_[touching_count_++] = felt * (contacts[i].nhat_W * multipliers_[i] + friction_W);
  }
  regions_.update({touching_.data(), touching_count_}, {forces_.data(), touching_count_}, tool_.state());
  return contact_F_T_W;
}

std::vector<BuiltPart> ConstrainedMotion::parts() const {
  std::vector<BuiltPart> parts{
      query_part(query_),
      {"response",
       "constraint: nearest free pose in the coupling's metric, at most " +
           std::to_string(features_ ? kFeatureRounds : kMaxRounds) + " rounds of " +
           std::to_string(kMaxContacts) + " rows a tick, " + (features_ ? "features" : "points") +
           " within " + number_text((features_ ? kLongestPairReach : reach_) * 1e3) + " mm" +
           (friction_ > 0 ? ", friction " + number_text(friction_) : std::string()),
       sizeof(ConstrainedMotion)},
  };
  if (features_)
    parts.push_back({"features",
                     "the tool's and the scene's vertices, edges and faces themselves, in place of the query",
                     features_->bytes()});
  if (edges_)
    parts.push_back(
        {"edge query", "the same of the scene's edges against the tool's field", edges_->bytes()});
  return parts;
}

}  // namespace fulcrum
