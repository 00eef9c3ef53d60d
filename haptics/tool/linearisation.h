#pragma once
// How a wrench on the tool changes with its motion: F_T_W(dx, V) = F - K dx - B (V - V_now), for an implicit
// integrator.

#include "haptics/math/linear.h"

namespace fulcrum {

// Rows and columns: translation of T, then rotation, in W.
struct Linearisation {
  Mat6 K = Mat6::Zero();  // (6 x 6) N/m, N, N m/rad: positive semi-definite
  Mat6 B = Mat6::Zero();  // (6 x 6) N s/m, N s, N m s

  void add_along(const Vec6& direction, double stiffness, double damping) {
    K.noalias() += stiffness * direction * direction.transpose();
    B.noalias() += damping * direction * direction.transpose();
  }
};

}  // namespace fulcrum
