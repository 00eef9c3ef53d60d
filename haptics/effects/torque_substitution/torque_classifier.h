#pragma once
// Good or bad torque: whether a force that the hand feels can be what holds the tool's rotation back.
//
//     u = tau / |tau|      F_proj = F - u (F . u)
//     bad = |tau_c| > eps  and  |tau| > T_min  and  |tau| > R_d |F_proj|
// (Eq. 1 and 2 of "Haptic rendering for under-actuated 6/3-DOF haptic devices", whose Eq. 1 lacks one of the
// two normalisations). A single push on the tool's surface has a lever of at most R_d and is good: yielding
// to the force takes the torque away. Two that work against each other add up to a torque without a force,
// and nothing that a device without torque motors can render tells the hand of it.
//
// The tool's own weight has no lever about T and is no part of F. Chatter is kept out twice: a torque that
// was bad stays so down to kRelease of both bounds, and until it has been good for kHold without a break,
// because stiff contact lets go for single ticks.

#include <cstdint>

#include "haptics/math/wrench.h"

namespace fulcrum {

struct TorqueBounds {
  double torque;   // N m, T_min
  double radius;   // m, R_d
  double contact;  // N m, eps: of the contact torque
};

class TorqueClassifier {
public:
  static constexpr double kRelease = 0.8;
  static constexpr double kHold = 10e-3;  // s

  TorqueClassifier(const TorqueBounds& bounds, double tick_s);

  // contact_torque (3) N m: of the scene; F_T_W: of the coupling, with the torque that its full stiffness
  // gives and without the part that carries the weight. Both on the tool, about T. True: bad.
  bool update(const Vec3& contact_torque, const Wrench& F_T_W) noexcept;

  bool bad() const { return bad_; }

private:
  bool beyond(const Vec3& contact_torque, const Wrench& F_T_W, double part) const noexcept;

  TorqueBounds bounds_;
  std::int64_t hold_ticks_;
  std::int64_t good_ticks_ = 0;
  bool bad_ = false;
};

}  // namespace fulcrum
