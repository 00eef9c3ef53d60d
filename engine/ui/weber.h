#pragma once
// What a hand does not notice of a change of force or torque. The smallest change that is noticed, about
// three times of four, is a fixed part of what is felt already (Weber's law):
//     force   7 to 10 % from 2.5 to 10 N   X. D. Pang, H. Z. Tan, N. I. Durlach, "Manual discrimination of
//                                          force using active finger motion", Perception & Psychophysics
//                                          49(6), 1991
//     torque  12.7 % about 60 mN m         L. Jandura, M. A. Srinivasan, "Experiments on human performance in
//                                          torque discrimination and control", ASME DSC-55-1, 1994
// Both between thumb and finger, by people who paid attention to nothing else. Below half a newton or so the
// part grows, and the true band is wider than the one that is drawn.

namespace fulcrum::ui {

inline constexpr double kForceWeber = 0.10;
inline constexpr double kTorqueWeber = 0.13;

// What feels the same as a value, in its unit: from the value of which it is the smallest noticed increase to
// the smallest noticed increase of it.
struct FeltSame {
  double low = 0.0, high = 0.0;
};

constexpr FeltSame felt_same(double value, double weber) {
  return {value / (1.0 + weber), value * (1.0 + weber)};
}

}  // namespace fulcrum::ui
