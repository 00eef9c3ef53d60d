#pragma once
// How well a manipulation point tells impacts apart by their vibration. From the axis alone every impact on
// { r e_r : e_r at right angles to it }, the circle of confusion, feels the same (J. Sreng et al.,
// "Spatialized haptic rendering", IEEE Virtual Reality 2009, 3.2); the frequency tells the distance along it.
// Two impacts at different places are taken for each other where their axes, with their sign, and their
// frequencies are too near.

#include <span>
#include <vector>

#include "haptics/math/linear.h"

namespace fulcrum::analysis::ambiguity {

struct ImpactSite {
  Vec3 p_T = Vec3::Zero();     // (3) m, on the tool
  Vec3 nhat_T = Vec3::Zero();  // (3) unit, of what strikes it there, towards the tool: inwards
};

// The last two are not the paper's: no frequency difference was tried.
struct AmbiguityDesc {
  double frequency_Hz = 40;  // of the material, beside the hand: the sinusoid of distance_model.h
  double axis_apart = 0.0872664625997165;  // rad, 5 degrees: axes nearer than this feel the same
  double frequency_apart = 1.2;            // frequencies whose ratio is smaller feel the same
  double place_apart = 0.01;               // m, sites nearer than this are one place
};

struct PointScore {
  Vec3 p_T = Vec3::Zero();  // (3) m, the manipulation point
  double confused = 0;      // of all sites, those that feel like one in another place
  double alike = 0;         // of all other sites, those that feel like a given one; mean over all
  double mistaken = 0;      // m, mean distance of the places that feel alike; 0: there are none
  double without_axis = 0;  // of all sites, those whose normal lies within 5 degrees of the lever
};

PointScore score_point(std::span<const ImpactSite> sites, const Vec3& p_T, const AmbiguityDesc& desc);

// All candidates, the least `alike` first; equal ones in their order.
std::vector<PointScore> rank_points(std::span<const ImpactSite> sites, std::span<const Vec3> candidates_T,
                                    const AmbiguityDesc& desc);

}  // namespace fulcrum::analysis::ambiguity
