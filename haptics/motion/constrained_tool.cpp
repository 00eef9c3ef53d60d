#include "haptics/motion/constrained_tool.h"

#include <algorithm>

#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

constexpr int kPasses = 3;              // in which normal forces and friction find each other
constexpr double kTouching = 50e-6;     // m, a point nearer than this belongs to a region
constexpr double kShortestWay = 1e-6;   // m, over a shorter one no stiffness can be told
constexpr double kShortestTurn = 1e-6;  // rad, the same of a turn
constexpr double kSoftestShare = 1e-4;  // of the coupling's stiffness, however far the hand is away

Vec6 metric(const CouplingDesc& coupling) {
  Vec6 m;
  m.head<3>().setConstant(coupling.stiffness);
  m.tail<3>().setConstant(coupling.angular_stiffness);
  return m;
}

}  // namespace

ConstrainedTool::ConstrainedTool(const PlainScene& desc, double slack, double radius)
    : tool_(desc),
      coupling_(desc.coupling),
      regions_(desc.contact.region_radius),
      metric_(metric(desc.coupling)),
      qp_(metric_, slack * desc.coupling.stiffness),
      contact_(desc.contact),
      radius_(radius) {}

void ConstrainedTool::begin(const Pose& X_WG) noexcept {
  X_WT_before_ = tool_.state().X_WT;
  metric_ = secant_metric(tool_.to_hand(X_WG), tool_.to_goal(X_WG));
  qp_.set_metric(metric_);
}

ToolAnswer ConstrainedTool::settle(const Pose& X_WG, const Twist& V_WG, bool is_late) noexcept {
  ToolAnswer answer;
  answer.X_WT = tool_.state().X_WT;
  answer.coupling_F_T_W = tool_.settle(X_WG, V_WG, is_late);
  answer.full_torque_T_W = tool_.coupling().full_torque();
  answer.turn_W = tool_.coupling().turn();
  answer.contact_F_T_W = share_force(answer.coupling_F_T_W);
  return answer;
}

Vec6 ConstrainedTool::solve(const Pose& X_WG, double skin) noexcept {
  const std::span<const Contact> contacts = contacts_.contacts();
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    rows_[i].a << contacts[i].nhat_W, Vec3(contacts[i].p_W - tool_.state().X_WT.p).cross(contacts[i].nhat_W);
    rows_[i].b = contacts[i].depth + skin;
  }
  const Vec6 goal = tool_.to_goal(X_WG);
  if (!has_friction(contact_)) return solve_rows(goal);
  // Rows have the last word: friction never pushes a point in.
  Vec6 rubbing = friction();
  for (int pass = 0; pass < kPasses; ++pass)
    rubbing = rub_along(solve_rows(goal + rubbing.cwiseQuotient(metric_)), rubbing);
  return solve_rows(goal + rubbing.cwiseQuotient(metric_));
}

Vec6 ConstrainedTool::secant_metric(const Vec6& to_hand, const Vec6& goal) const noexcept {
  Vec3 pull = saturated_spring(to_hand.head<3>(), coupling_.stiffness, coupling_.max_force);
  pull.y() -= tool_.weight();
  const Vec3 twist = saturated_spring(goal.tail<3>(), coupling_.angular_stiffness, coupling_.max_torque);
  const double way = goal.head<3>().norm(), turn = goal.tail<3>().norm();
  CouplingDesc secant = coupling_;
  if (way > kShortestWay)
    secant.stiffness =
        std::clamp(pull.norm() / way, kSoftestShare * coupling_.stiffness, coupling_.stiffness);
  if (turn > kShortestTurn)
    secant.angular_stiffness = std::max(twist.norm() / turn, kSoftestShare * coupling_.angular_stiffness);
  return metric(secant);
}

Vec6 ConstrainedTool::solve_rows(const Vec6& goal) noexcept {
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
    pushing_[pushing_count_++] = {
        .point = contacts[i].point,
        .contact = i,
        .multiplier = multipliers_[i],
        .r_W = contacts[i].p_W - tool_.state().X_WT.p,
        .friction_W = pushed ? before[next].friction_W : Vec3(Vec3::Zero()),
        .friction_torque_W = pushed ? before[next].friction_torque_W : Vec3(Vec3::Zero())};
  }
  return step;
}

Vec6 ConstrainedTool::friction() const noexcept {
  Vec6 sum = Vec6::Zero();
  for (std::size_t i = 0; i < pushing_count_; ++i) {
    sum.head<3>() += pushing_[i].friction_W;
    sum.tail<3>() += pushing_[i].r_W.cross(pushing_[i].friction_W) + pushing_[i].friction_torque_W;
  }
  return sum;
}

Vec6 ConstrainedTool::rub_along(Vec6 step, const Vec6& under) noexcept {
  const Pose& X_WT = tool_.state().X_WT;
  std::array<RubbingPoint, ElasticQp::kMaxActive> points;
  for (std::size_t i = 0; i < pushing_count_; ++i) {
    const Contact& contact = contacts_.contacts()[pushing_[i].contact];
    const Vec3 p_T = X_WT.inverse() * contact.p_W;
    points[i] = {.nhat_W = contact.nhat_W,
                 .r_W = pushing_[i].r_W,
                 .slip_W = contact.p_W - X_WT_before_ * p_T,
                 .normal_force = pushing_[i].multiplier,
                 .force_W = pushing_[i].friction_W,
                 .torque_W = pushing_[i].friction_torque_W};
  }
  // Points that no longer push no longer rub.
  step += (friction() - under).cwiseQuotient(metric_);
  const Vec3 turned_W = rotation_vector(X_WT.q * X_WT_before_.q.conjugate());
  Vec6 now = rub(metric_, contact_, step, turned_W, {points.data(), pushing_count_});
  for (std::size_t i = 0; i < pushing_count_; ++i) {
    pushing_[i].friction_W = points[i].force_W;
    pushing_[i].friction_torque_W = points[i].torque_W;
  }
  return now;
}

// The tool has no mass: what the coupling and the weight leave over, the scene gives. The rows' forces tell
// how it is shared out; where the coupling's spring saturates they are larger than what is felt.
Wrench ConstrainedTool::share_force(const Wrench& coupling_F_T_W) noexcept {
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
  const double arm = 1.0 / (radius_ * radius_);
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

}  // namespace fulcrum
