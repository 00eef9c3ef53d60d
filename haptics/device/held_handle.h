#pragma once
// A handle in a hand that holds it elsewhere than at its origin: at G, on a lever p_HG. There its translation
// and rotation mix, and FrictionAxis, which solves each axis for itself, does not serve.
//     (M_h + M G^T G) V' = F - B_h V - mu sgn(V) + G^T f_G + hand's torque,   v_G = G V = v + w x p_HG
//     f_G = k (x_t - x_G) + b (v_t - v_G),   M: the hand's mass, at G
// with M_h, B_h and mu diagonal: translation along D's axes, rotation about the handle's own. Sub-steps of
// the implicit midpoint rule, order 2, which leaves the energy of a spring what it is. Coulomb friction is
// exact in each: the velocity of its middle is where
//     w^T A w / 2 - r^T w + h / 2 sum_i mu_i |w_i|
// is least, a convex problem with one answer. Left out: that the axes of inertia turn within a sub-step.

#include "haptics/math/pose.h"
#include "haptics/math/wrench.h"

namespace fulcrum {

class HeldHandle {
public:
  struct Figures {                 // translation, then rotation about the handle's axes
    Vec6 mass = Vec6::Ones();      // (6) kg; kg m^2
    Vec6 damping = Vec6::Zero();   // (6) N s/m; N m s
    Vec6 friction = Vec6::Zero();  // (6) N; N m, Coulomb
    double hand_mass = 0;          // kg, at G
    double stiffness = 0;          // N/m, of the hand at G
    double hand_damping = 0;       // N s/m
    double angular_stiffness = 0;  // N m/rad
    double angular_damping = 0;    // N m s
  };
  HeldHandle(const Figures& figures, const Pose& X_DH) : figures_(figures), X_DH_(X_DH) {}

  struct Load {                // held through a tick, but for the hand, which moves evenly
    Wrench F_H_D;              // on the handle about H
    Vec3 p_HG = Vec3::Zero();  // (3) m
    Pose X_DH_wanted;          // where the hand wants the handle at the start
    Twist V_wanted;            // its motion in D
  };
  void advance(const Load& load, double tick_s) noexcept;

  const Pose& X_DH() const { return X_DH_; }
  Vec3 velocity() const { return V_.head<3>(); }  // (3) m/s, in D
  void push(const Vec3& v_D) noexcept { V_.head<3>() = v_D; }
  // What the hand felt of the handle over the last tick, in the mean: about G, in D.
  const Wrench& felt() const { return felt_; }

private:
  Vec6 middle(const Mat6& A, const Vec6& r, double h) const noexcept;
  void substep(const Load& load, const Pose& X_DH_wanted, double h) noexcept;

  Figures figures_;
  Pose X_DH_;
  Vec6 V_ = Vec6::Zero();  // (6) m/s in D; rad/s about the handle's axes
  Wrench felt_;
};

}  // namespace fulcrum
