#pragma once
// How a material answers to a blow: Q(t) = A v e^(-B t) sin(2 pi f t) for a blow of v m/s. A. M. Okamura, J.
// T. Dennerlein, R. D. Howe, "Vibration feedback models for virtual environments", ICRA 1998.

#include <string>

namespace fulcrum {

struct ImpactMaterial {
  std::string name = "steel";
  double attack = 0.8;       // A, kg/s: N for each m/s of approach
  double decay = 5;          // B, 1/s
  double frequency_Hz = 40;  // f, of an impact beside the hand, see distance_model.h
};

}  // namespace fulcrum
