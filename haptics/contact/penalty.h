#pragma once
// Penalty response: a spring and damper for each contact region.
//
// Touching points share the stiffness of the region they lie in, so that sampling is not felt: point i gets
//     share_i = v_i / sum_j K_ij v_j,   v = area x depth (its part of the overlap volume; contacts that stand
//                                       for several points have the sum, and their mean depth d weighted by
//                                       it),
//     K_ij    = max(0, nhat_i . nhat_j) (1 - |p_i - p_j|^2 / R^2)^2  within R, else 0
// A tight cluster's shares add up to 1, two clusters farther apart than R to 2, and in between they change
// smoothly: no force jump where regions meet or part. On each point acts
//     f_i = share_i k d_i max(0, 1 + c u_i) nhat_i,   u the approach speed
// (Hunt and Crossley 1975, J. Applied Mechanics 42), continuous at first touch and never pulling.
//
// Stability under semi-implicit Euler: with 1/m_i = 1/m + (r x n)^T I^-1 (r x n), the largest eigenvalue of
// M^-1 K is at most sum k_i / m_i. That sum is capped at kStiffnessShare / T^2 and the dampers' at
// kDampingShare / T, which keeps T^2 w^2 < 4 - 2 T c with room for the coupling. Implicit Euler needs no cap
// and gets the linearisation instead.

#include <array>
#include <cstdint>
#include <span>

#include "haptics/contact/contact_desc.h"
#include "haptics/contact/contact_set.h"
#include "haptics/math/wrench.h"
#include "haptics/tool/rigid_body.h"

namespace fulcrum {

inline constexpr double kStiffnessShare = 0.5;
inline constexpr double kDampingShare = 0.5;

class PenaltyResponse {
public:
  PenaltyResponse(const ContactDesc& desc, const RigidBody& tool, double tick_s, Integrator integrator);

  struct Answer {
    Wrench F_T_W;                   // on the tool, about T
    bool stiffness_capped = false;  // the tick could not hold the summed stiffness
  };
  Answer push(const ContactSet& set, const BodyState& tool) noexcept;

  double stiffness() const { return desc_.stiffness; }  // N/m, of a region
  // From the next push on; a spring that is pressed by then makes energy.
  void stiffen(double stiffness) noexcept { desc_.stiffness = stiffness; }

  // Adds that of the last push().
  void linearise(const ContactSet& set, const BodyState& tool, Linearisation& around) const noexcept;

  // Force on the tool from each contact of the last push(), (n x 3) N in W.
  std::span<const Vec3> forces() const { return {force_.data(), count_}; }
  // Stiffness of each, (n) N/m, likewise.
  std::span<const double> stiffnesses() const { return {stiffness_.data(), count_}; }

private:
  struct Scale {
    double stiffness = 1, dissipation = 1;
  };
  Scale cap(std::span<const Contact> contacts, const BodyState& tool) const noexcept;
  void share_stiffness(std::span<const Contact> contacts) noexcept;

  ContactDesc desc_;
  RigidBody tool_;
  double tick_s_;
  bool capped_;
  std::size_t count_ = 0;
  std::array<Vec3, kMaxContacts> pressed_W_{};  // (3) m, of each contact at the last push
  std::array<double, kMaxContacts> share_{};
  std::array<double, kMaxContacts> stiffness_{};  // N/m, of each contact at the last push
  std::array<double, kMaxContacts>
      damping_{};  // N s/m, of each contact at the last push; 0 where the damper had let go
  std::array<Vec3, kMaxContacts> force_{};
};

}  // namespace fulcrum
