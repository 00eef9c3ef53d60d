#include "haptics/contact/region_friction.h"

#include <algorithm>
#include <cmath>

#include "haptics/contact/friction.h"
#include "haptics/math/clamp_norm.h"
#include "haptics/math/functions.h"
#include "haptics/math/rotation.h"

namespace fulcrum {
namespace {

// Of a region's springs: a newton stretches them by a micrometre. Much stiffer ones let go within what a pose
// is rounded to.
constexpr double kStiffest = 1e6;  // N/m

Mat3 cross_matrix(const Vec3& v) {
  Mat3 m;
  m << 0, -v.z(), v.y(), v.z(), 0, -v.x(), -v.y(), v.x(), 0;
  return m;
}

Vec3 along_surface(const Vec3& v, const Vec3& nhat) {
  return v - nhat * nhat.dot(v);
}

}  // namespace

RegionFriction::RegionFriction(const ContactDesc& desc)
    : sliding_(desc.friction),
      torsional_(desc.torsional_friction),
      rolling_(desc.rolling_friction),
      radius_(desc.region_radius) {}

RegionFriction::RegionFriction(const ContactDesc& desc, const RigidBody& tool, double tick_s)
    : RegionFriction(desc) {
  body_ = tool;
  tick_s_ = tick_s;
}

Wrench RegionFriction::rub(const Pressed& pressed, const BodyState& tool) noexcept {
  begin(pressed, tool);
  const double damping_s = bear(tool);
  Wrench sum;
  for (std::size_t r = 0; r < count_; ++r) {
    stretch(rubbing_[r], tool);
    const Wrench F_W = pull(rubbing_[r], tool, damping_s);
    force_W_[r] = F_W.force;
    sum += {F_W.force, F_W.torque + rubbing_[r].r_W.cross(F_W.force)};
  }
  return sum;
}

// What each region is pushed by, where, and how far its points lie apart.
void RegionFriction::begin(const Pressed& pressed, const BodyState& tool) noexcept {
  count_ = 0;
  for (const std::uint16_t region : pressed.region_of) count_ = std::max<std::size_t>(count_, region + 1u);
  const std::span<Rubbing> all = std::span(rubbing_).first(count_);
  std::fill(all.begin(), all.end(), Rubbing{});
  for (std::size_t i = 0; i < pressed.contacts.size(); ++i) {
    Rubbing& rubbing = rubbing_[pressed.region_of[i]];
    const double load = pressed.forces[i].norm();
    rubbing.load += load;
    rubbing.p_W += load * pressed.contacts[i].p_W;
    rubbing.nhat_W += load * pressed.contacts[i].nhat_W;
    rubbing.stiffness += kAlong * pressed.stiffness[i];
  }
  for (Rubbing& rubbing : all) {
    if (!(rubbing.load > 0)) continue;
    rubbing.p_W /= rubbing.load;
    rubbing.r_W = rubbing.p_W - tool.X_WT.p;
    rubbing.nhat_W.normalize();
    rubbing.held_load = rubbing.load;
    rubbing.stiffness = std::min(rubbing.stiffness, kStiffest);
  }
  for (std::size_t i = 0; i < pressed.contacts.size(); ++i) {
    Rubbing& rubbing = rubbing_[pressed.region_of[i]];
    if (rubbing.load > 0)
      rubbing.spread +=
          pressed.forces[i].norm() / rubbing.load * (pressed.contacts[i].p_W - rubbing.p_W).norm();
  }
}

// Keeps the springs within what the tool's mass bears in a tick. Answers the dampers' damping over the
// springs' stiffness, s.
double RegionFriction::bear(const BodyState& tool) noexcept {
  if (!body_) return 0;
  const Mat3 inverse_inertia_W = body_->inverse_inertia_W(tool.X_WT.q);
  double over_mass = 0, slowest = 0;  // 1/s^2: of all motions, and of the tool as a whole
  for (const Rubbing& rubbing : std::span(rubbing_).first(count_)) {
    const Mat3 arm = cross_matrix(rubbing.r_W);
    const double turns = -(arm * inverse_inertia_W * arm).trace();
    const double about = rubbing.nhat_W.dot(inverse_inertia_W * rubbing.nhat_W);
    over_mass +=
        rubbing.stiffness * (2 / body_->mass() + turns + math::square(spin_lever(rubbing)) * about +
                             math::square(roll_lever(rubbing)) * (inverse_inertia_W.trace() - about));
    slowest += rubbing.stiffness / body_->mass();
  }
  if (!(over_mass > 0)) return 0;
  const double most = kFrictionShare / (tick_s_ * tick_s_), part = std::min(1.0, most / over_mass);
  for (Rubbing& rubbing : std::span(rubbing_).first(count_)) rubbing.stiffness *= part;
  // Critical for the tool as a whole, if the tick bears that.
  return std::min(2 / std::sqrt(part * slowest), kFrictionShare / (tick_s_ * part * over_mass));
}

// From where they were kept on: what was a region then is stretched by what the tool's material has moved at
// the centre of pressure.
void RegionFriction::stretch(Rubbing& rubbing, const BodyState& tool) const noexcept {
  const Kept* before = nullptr;
  double nearest = math::square(radius_);
  for (const Kept& kept : std::span(kept_).first(kept_count_)) {
    const double apart = (kept.p_W - rubbing.p_W).squaredNorm();
    if (apart >= nearest || kept.nhat_W.dot(rubbing.nhat_W) <= 0) continue;
    nearest = apart;
    before = &kept;
  }
  // A tool without mass finds its balance in steps, in which springs may press a thousand times as hard as
  // they do there: there friction is that of the balance before.
  if (!body_) rubbing.held_load = before == nullptr ? 0.0 : std::min(rubbing.load, before->load);
  if (before == nullptr) return;
  const Vec3 p_T = tool.X_WT.q.conjugate() * rubbing.r_W;
  const Vec3 moved_W = rubbing.p_W - X_WT_kept_ * p_T;
  const Vec3 turn_W = before->turn_W + rotation_vector(tool.X_WT.q * X_WT_kept_.q.conjugate());
  rubbing.way_W = along_surface(before->way_W + moved_W, rubbing.nhat_W);
  rubbing.roll_W = along_surface(turn_W, rubbing.nhat_W);
  rubbing.spin_W = turn_W - rubbing.roll_W;
}

// The region's force and torque, about its centre of pressure.
Wrench RegionFriction::pull(Rubbing& rubbing, const BodyState& tool, double damping_s) const noexcept {
  if (!(rubbing.held_load > 0)) {
    rubbing.held = rubbing.roll_held = 0;
    return {};
  }
  const double spin_stiffness = rubbing.stiffness * math::square(spin_lever(rubbing)),
               roll_stiffness = rubbing.stiffness * math::square(roll_lever(rubbing));
  const double most = sliding_ * rubbing.held_load,
               most_spin = (sliding_ * rubbing.spread + torsional_) * rubbing.held_load,
               most_roll = rolling_ * rubbing.held_load;
  const auto share = [](double size, double limit) { return size > 0 ? size / limit : 0.0; };
  const auto held = [&](const Vec3& force, const Vec3& torque) {
    return std::min(1.0, 1 / math::hypot(share(force.norm(), most), share(torque.norm(), most_spin)));
  };
  Vec3 force = -rubbing.stiffness * rubbing.way_W, spin = -spin_stiffness * rubbing.spin_W,
       roll = -roll_stiffness * rubbing.roll_W;
  rubbing.held = held(force, spin);
  rubbing.roll_held = std::min(1.0, 1 / share(roll.norm(), most_roll));
  force *= rubbing.held;
  spin *= rubbing.held;
  roll *= rubbing.roll_held;
  if (damping_s > 0) {
    const Vec3 v_W = along_surface(tool.V_WT.v + tool.V_WT.w.cross(rubbing.r_W), rubbing.nhat_W);
    const Vec3 rolls_W = along_surface(tool.V_WT.w, rubbing.nhat_W);
    force -= damping_s * rubbing.stiffness * v_W;
    spin -= damping_s * spin_stiffness * (tool.V_WT.w - rolls_W);
    roll -= damping_s * roll_stiffness * rolls_W;
    const double part = held(force, spin);
    force *= part;
    spin *= part;
  }
  return {force, spin + clamp_norm(roll, most_roll)};
}

// What slides gives way freely the way that it slides: of the springs' stiffness K about a stretch x,
// K - (K x)(K x)^T / x^T K x is left, times how much of them friction holds.
void RegionFriction::linearise(Linearisation& around) const noexcept {
  for (const Rubbing& rubbing : std::span(rubbing_).first(count_)) {
    const double k = rubbing.stiffness, k_spin = k * math::square(spin_lever(rubbing)),
                 k_roll = k * math::square(roll_lever(rubbing));
    const Mat3 normal = rubbing.nhat_W * rubbing.nhat_W.transpose(), along = Mat3::Identity() - normal;
    Eigen::Matrix<double, 3, 6> way;
    way << along, -along * cross_matrix(rubbing.r_W);
    Mat6 K = k * way.transpose() * way;
    K.bottomRightCorner<3, 3>() += k_spin * normal;
    if (rubbing.held < 1) {
      Vec6 force = k * way.transpose() * rubbing.way_W;
      force.tail<3>() += k_spin * rubbing.spin_W;
      const double work = k * rubbing.way_W.squaredNorm() + k_spin * rubbing.spin_W.squaredNorm();
      if (work > 0) K -= force * force.transpose() / work;
    }
    around.K += rubbing.held * K;
    Mat3 K_roll = k_roll * along;
    const double squared = rubbing.roll_W.squaredNorm();
    if (rubbing.roll_held < 1 && squared > 0)
      K_roll -= k_roll * rubbing.roll_W * rubbing.roll_W.transpose() / squared;
    around.K.bottomRightCorner<3, 3>() += rubbing.roll_held * K_roll;
  }
}

void RegionFriction::keep(const BodyState& tool) noexcept {
  X_WT_kept_ = tool.X_WT;
  kept_count_ = 0;
  for (const Rubbing& rubbing : std::span(rubbing_).first(count_)) {
    if (!(rubbing.load > 0)) continue;
    kept_[kept_count_++] = {rubbing.p_W, rubbing.nhat_W, rubbing.held * rubbing.way_W,
                            rubbing.held * rubbing.spin_W + rubbing.roll_held * rubbing.roll_W, rubbing.load};
  }
}

std::string RegionFriction::note() const {
  return "springs along the surface of each region" +
         friction_note(
             {.friction = sliding_, .torsional_friction = torsional_, .rolling_friction = rolling_});
}

}  // namespace fulcrum
