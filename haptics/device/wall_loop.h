#pragma once
// One axis of a device against a virtual wall on both sides: what stability is asked of.
//     m x'' = F - b x' - f_c sgn(x'),    F = -K x - B u,    computed each tick, then held
//     u = filter_pole u_before + (1 - filter_pole) (x - x_before) / T
// The law is this simulator's coupling against a still tool, with the velocity estimator `difference`
// (filter_pole = 0) or `low_pass`.

namespace fulcrum {

struct DeviceAxis {
  double mass = 0.1;        // kg
  double damping = 0.5;     // N s/m
  double friction = 0;      // N, Coulomb
  double encoder_step = 0;  // m, 0: exact

  // A loop with neither grows or decays at the same rate from any start.
  bool linear() const { return friction == 0 && encoder_step == 0; }
};

struct WallLoop {
  DeviceAxis axis;
  double tick_s = 1e-3;
  int delay_ticks = 0;     // whole ticks from the sample to the motors, 0 to 8
  double filter_pole = 0;  // of the velocity estimator's low-pass, 0 to 1
};

struct Wall {
  double K = 0;  // N/m
  double B = 0;  // N s/m
};

}  // namespace fulcrum
