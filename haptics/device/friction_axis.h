#pragma once
// One axis of a device in a hand: a mass with viscous and Coulomb friction, pushed by a force that is held
// over a tick, and held by a spring and damper whose other end moves at a constant speed through the tick.
//     m x'' = f - b x' - f_c sgn(x') - k_h (x - x_h - v_h t) - b_h (x' - v_h)
// Solved exactly between the events at which the mass sticks or breaks loose: sub-stepping would damp it.

namespace fulcrum {

struct FrictionAxis {
  double mass = 1;      // kg, or kg m^2
  double damping = 0;   // N s/m, or N m s
  double friction = 0;  // N, or N m: Coulomb
  double x = 0;         // m, or rad
  double v = 0;         // m/s, or rad/s

  struct Load {
    double force = 0;      // N or N m, held through the tick
    double stiffness = 0;  // of the hand
    double hand_damping = 0;
    double hand_x = 0;  // at the start of the tick
    double hand_v = 0;
  };
  void advance(const Load& load, double tick_s) noexcept;

private:
  double slide(const Load& load, double sign, double t) noexcept;
};

}  // namespace fulcrum
