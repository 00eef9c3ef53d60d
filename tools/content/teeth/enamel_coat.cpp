#include <algorithm>
#include <cmath>
#include <cstddef>

#include "haptics/math/functions.h"
#include "tools/content/mesh/paint.h"
#include "tools/content/mesh/smooth.h"
#include "tools/content/mesh/surface_nets.h"
#include "tools/content/teeth/ambience.h"
#include "tools/content/teeth/coat.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

// Linear colours, chosen by eye after shade A2 of a common shade guide.
const Vector3d enamel(0.93, 0.80, 0.605);
const Vector3d cervical(0.83, 0.60, 0.35);  // dentine shows through
const Vector3d incisal(0.60, 0.62, 0.61);   // nothing but enamel there: it lets the dark behind it through
const Vector3d halo(0.90, 0.84, 0.72);      // the very edge, where light is thrown back inside
const Vector3d cusp(0.92, 0.83, 0.68);      // thick enamel
const Vector3d stain(0.17, 0.09, 0.04);     // of fissures
const Vector3d beside_teeth(0.70, 0.30, 0.26);

// How translucent an incisal edge is: between the three lobes of dentine, which are the mamelons a tooth came
// with, more and further down.
double translucency(const Tooth& tooth, const Vector3d& p_T) {
  const double width = tooth.half_width / tooth.size;
  const double lobes = 0.5 - 0.5 * math::cos(3.0 * pi * (p_T.x() / width + 1.0));
  const double to_side = smooth_step(0.72, 0.95, std::abs(p_T.x()) / width);
  const double reach = 1.8 + 0.7 * std::max(1.0 - lobes, to_side) + 0.2 * mottle(1.1 * p_T);
  const double below_edge = tooth.crown_length - p_T.z();
  return smooth_step(1.25 * reach, 0.0, below_edge);
}

Vector3d enamel_colour(const Tooth& tooth, const Vector3d& p_T) {
  const double up = p_T.z() / tooth.crown_length;
  Vector3d colour = mixed(cervical, enamel, smooth_step(-0.05, 0.55, up + 0.04 * mottle(0.8 * p_T)));
  const double under_top = tooth.design.relief.height(p_T.x(), p_T.y()) - p_T.z();
  if (tooth.design.relief.cusps.empty()) {
    if (tooth.number % 10 < 3) {
      colour = mixed(colour, incisal, 0.8 * translucency(tooth, p_T));
      colour = mixed(colour, halo, 0.45 * smooth_step(0.22, 0.05, under_top));
    } else {
      colour = mixed(colour, incisal, 0.4 * smooth_step(0.78, 1.0, up));
    }
  } else {
    colour = mixed(colour, cusp, 0.8 * smooth_step(0.7, 0.98, up));
  }
  const double fissure = tooth.design.relief.fissure(p_T.x(), p_T.y()) * smooth_step(0.8, 0.2, under_top);
  colour = mixed(colour, stain, 0.95 * math::pow(fissure, 0.7) * (0.85 + 0.35 * mottle(1.5 * p_T)));
  return colour * (1.0 + 0.03 * mottle(0.9 * p_T));
}

}  // namespace

Coat enamel_coat(const Dentition& dentition, const Gum& gum, std::size_t index, const Solid& solid) {
  const Tooth& tooth = dentition.teeth[index];
  const auto body = [&](const Vector3d& p) { return tooth.distance(p); };
  const auto scene = [&](const Vector3d& p) {
    const double to_teeth = teeth_distance(dentition, index, p);
    return tooth.to_tooth(p).z() > 6.5 ? to_teeth : std::min(to_teeth, gum.distance(p));
  };
  Coat coat;
  for (const Vector3d& p : solid.points) {
    const Vector3d n = gradient(body, p, 0.05).normalized();
    const Vector3d colour = enamel_colour(tooth, tooth.to_tooth(p));
    const double near_gum = smooth_step(-2.0, 0.5, gum.below_margin(p));
    coat.normals.push_back(n);
    coat.colours.push_back(
        shut_in(colour, openness(scene, p, n, surroundings), mixed(colour, beside_teeth, near_gum)));
  }
  return coat;
}

}  // namespace fulcrum::content
