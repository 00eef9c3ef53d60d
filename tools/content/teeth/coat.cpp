#include "tools/content/teeth/coat.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <vector>

#include "tools/content/mesh/paint.h"
#include "tools/content/mesh/profile.h"
#include "tools/content/mesh/smooth.h"
#include "tools/content/mesh/surface_nets.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

// Linear colours, chosen by eye after shade A2 of a common shade guide and photographs of healthy gingiva.
const Vector3d enamel(0.89, 0.745, 0.57);
const Vector3d cervical(0.79, 0.56, 0.33);  // dentine shows through
const Vector3d incisal(0.74, 0.72, 0.66);   // nothing but enamel there: it lets the dark behind it through
const Vector3d stain(0.20, 0.115, 0.055);   // of fissures
const Vector3d free_gingiva(0.66, 0.25, 0.22);
const Vector3d attached(0.72, 0.33, 0.29);
const Vector3d mucosa(0.52, 0.145, 0.13);

const std::vector<double> surroundings{0.25, 0.6, 1.3, 2.6};  // mm

double teeth_distance(const Dentition& dentition, std::size_t around, const Vector3d& p) {
  double least = 1e3;
  const std::size_t last = dentition.teeth.size() - 1;
  for (std::size_t i = around == 0 ? 0 : around - 1; i <= std::min(around + 1, last); ++i) {
    least = std::min(least, dentition.teeth[i].distance(p));
  }
  return least;
}

// Where the attached gingiva ends and the loose mucosa begins: mm, y along the arch.
double mucogingival_line(double along) {
  static const Profile line({{0, -15.2}, {14, -15.2}, {25, -14.4}, {40, -13.8}, {50, -12.5}, {55, -11.5}});
  return line(std::abs(along));
}

// Attached gingiva is dimpled like an orange's peel; so fine that it tilts the normal alone.
Vector3d stipple(const Vector3d& p, double along) {
  const double loose = smooth_step(0.5, -1.5, p.y() - mucogingival_line(along));
  const Vector3d q = 3.4 * p;
  return (0.045 - 0.035 * loose) *
         Vector3d(mottle(q), mottle(q + Vector3d(7.1, 3.3, 1.9)), mottle(q + Vector3d(2.7, 9.1, 5.3)));
}

Vector3d enamel_colour(const Tooth& tooth, const Vector3d& p_T) {
  const double up = p_T.z() / tooth.crown_length;
  Vector3d colour = mixed(cervical, enamel, smooth_step(0.0, 0.5, up));
  const bool has_edge = tooth.design.relief.cusps.empty();
  if (has_edge) colour = mixed(colour, incisal, 0.85 * smooth_step(0.7, 1.0, up));
  const double under_top = tooth.design.relief.height(p_T.x(), p_T.y()) - p_T.z();
  const double fissure = tooth.design.relief.fissure(p_T.x(), p_T.y()) * smooth_step(0.8, 0.2, under_top);
  colour = mixed(colour, stain, 0.75 * std::pow(fissure, 0.7));
  return colour * (1.0 + 0.03 * mottle(0.9 * p_T));
}

Vector3d gum_colour(double below, double along, const Vector3d& p) {
  Vector3d colour = mixed(free_gingiva, attached, smooth_step(0.3, 1.8, below));
  colour =
      mixed(colour, mucosa, smooth_step(0.8, -1.6, p.y() - mucogingival_line(along) + 0.7 * mottle(0.5 * p)));
  return colour * (1.0 + 0.07 * mottle(1.3 * p));
}

}  // namespace

Coat enamel_coat(const Dentition& dentition, const Gum& gum, std::size_t index, const Solid& solid) {
  const Tooth& tooth = dentition.teeth[index];
  const auto body = [&](const Vector3d& p) { return tooth.distance(p); };
  const auto scene = [&](const Vector3d& p) {
    const double to_teeth = teeth_distance(dentition, index, p);
    return tooth.to_tooth(p).z() > 5.5 ? to_teeth : std::min(to_teeth, gum.distance(p));
  };
  Coat coat;
  for (const Vector3d& p : solid.points) {
    const Vector3d n = gradient(body, p, 0.05).normalized();
    const Vector3d colour = enamel_colour(tooth, tooth.to_tooth(p));
    const double near_gum = smooth_step(-2.0, 0.5, gum.below_margin(p));
    coat.normals.push_back(n);
    coat.colours.push_back(
        shut_in(colour, openness(scene, p, n, surroundings), mixed(colour, attached, near_gum)));
  }
  return coat;
}

Coat gum_coat(const Dentition& dentition, const Gum& gum, const Solid& solid) {
  const auto body = [&](const Vector3d& p) { return gum.distance(p); };
  Coat coat;
  for (const Vector3d& p : solid.points) {
    const double along = dentition.arch.foot({p.x(), p.z()}).along;
    const std::size_t tooth = dentition.nearest(along);
    const auto scene = [&](const Vector3d& q) {
      return std::min(gum.distance(q), teeth_distance(dentition, tooth, q));
    };
    const Vector3d n = (gradient(body, p, 0.25).normalized() + stipple(p, along)).normalized();
    const Vector3d colour = gum_colour(gum.below_margin(p), along, p);
    coat.normals.push_back(n);
    coat.colours.push_back(shut_in(colour, openness(scene, p, n, surroundings), colour));
  }
  return coat;
}

}  // namespace fulcrum::content
