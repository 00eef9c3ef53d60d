#pragma once
// Coulomb friction where springs push: each contact region holds the tool by springs along the surface, which
// give way where they would pull more than friction can. It sticks without creeping, and slides against the
// motion. Of a region that is pushed by N, with k the stiffness of its points together:
//     along the surface   |f| <= friction N             by k_t = kAlong k
//     about the normal    |t| <= (friction a + c_t) N   by k_t (a + c_t / friction)^2
//     rolling             |t| <= c_r N                  by k_t (a + c_r / friction)^2
// with c_t the scene's torsional_friction and c_r its rolling_friction (m), and a the mean distance of the
// pressed points from the centre of pressure, weighted by how hard they are pushed. Force and spin share what
// there is: (f / f_max)^2 + (t / t_max)^2 <= 1 (R. D. Howe, M. R. Cutkosky, "Practical force-motion models
// for sliding manipulation", Int. J. Robotics Research 15(6), 1996).
//
// Tested up to a coefficient of 3 on contact of 1e7 N/m. At 10 a tool without mass may stay out of balance
// there.
//
// On a tool with mass springs and dampers together stay within kFrictionShare of what semi-implicit Euler
// bears, as those of penalty.h within theirs.

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>

#include "haptics/contact/contact_desc.h"
#include "haptics/contact/contact_set.h"
#include "haptics/math/wrench.h"
#include "haptics/tool/rigid_body.h"

namespace fulcrum {

class RegionFriction {
public:
  static constexpr double kAlong = 0.5;  // of a region's stiffness; R. D. Mindlin, 1949, has 0.8 for steel
  static constexpr double kFrictionShare = 0.25;

  explicit RegionFriction(const ContactDesc& desc);                               // on a tool without mass
  RegionFriction(const ContactDesc& desc, const RigidBody& tool, double tick_s);  // on one with mass

  struct Pressed {
    std::span<const Contact> contacts;         // at most kMaxContacts
    std::span<const std::uint16_t> region_of;  // (contacts) below kMaxRegions
    std::span<const Vec3> forces;              // (contacts x 3) N in W, on the tool by their springs
    std::span<const double> stiffness;         // (contacts) N/m, of those
  };
  // The wrench on the tool about T, where it is now. A region is one that was kept if its centre of pressure
  // is within the regions' radius of that one's.
  Wrench rub(const Pressed& pressed, const BodyState& tool) noexcept;
  // Adds that of the last rub().
  void linearise(Linearisation& around) const noexcept;
  // What the last rub() found is how things stand: from there on the springs are stretched.
  void keep(const BodyState& tool) noexcept;
  // (regions x 3) N in W, of the last rub().
  std::span<const Vec3> forces() const { return {force_W_.data(), count_}; }

  std::string note() const;  // of parts()

private:
  struct Rubbing {
    Vec3 p_W = Vec3::Zero(), r_W = Vec3::Zero();  // (3) m, centre of pressure, and from T
    Vec3 nhat_W = Vec3::Zero();                   // (3) unit
    double held_load = 0;                         // N, of which friction is a part
    double load = 0, spread = 0;                  // N and m: N and a of above
    double stiffness = 0;                         // N/m, along the surface
    // How far the springs are stretched, (3) m and rad in W, and how much of that friction holds.
    Vec3 way_W = Vec3::Zero(), spin_W = Vec3::Zero(), roll_W = Vec3::Zero();
    double held = 1, roll_held = 1;
  };
  void begin(const Pressed& pressed, const BodyState& tool) noexcept;
  void stretch(Rubbing& rubbing, const BodyState& tool) const noexcept;
  double bear(const BodyState& tool) noexcept;
  Wrench pull(Rubbing& rubbing, const BodyState& tool, double damping_s) const noexcept;

  // m, at which springs as stiff as along the surface let go after as long a way.
  double spin_lever(const Rubbing& rubbing) const { return rubbing.spread + over_sliding(torsional_); }
  double roll_lever(const Rubbing& rubbing) const { return rubbing.spread + over_sliding(rolling_); }
  double over_sliding(double length) const { return sliding_ > 0 ? length / sliding_ : length; }

  double sliding_, torsional_, rolling_;  // coefficient, and m
  double radius_;                         // m, of regions
  std::optional<RigidBody> body_;
  double tick_s_ = 0;
  Pose X_WT_kept_;
  struct Kept {
    Vec3 p_W = Vec3::Zero(), nhat_W = Vec3::Zero();
    Vec3 way_W = Vec3::Zero(), turn_W = Vec3::Zero();
    double load = 0;  // N
  };
  std::array<Kept, kMaxRegions> kept_{};
  std::array<Rubbing, kMaxRegions> rubbing_{};
  std::array<Vec3, kMaxRegions> force_W_{};
  std::size_t kept_count_ = 0, count_ = 0;
};

}  // namespace fulcrum
