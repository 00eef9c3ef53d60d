#include <algorithm>
#include <cmath>
#include <cstddef>

#include "haptics/math/functions.h"
#include "tools/content/mesh/paint.h"
#include "tools/content/mesh/profile.h"
#include "tools/content/mesh/smooth.h"
#include "tools/content/mesh/surface_nets.h"
#include "tools/content/teeth/ambience.h"
#include "tools/content/teeth/coat.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

// Linear colours, chosen by eye after photographs of healthy gingiva.
const Vector3d free_gingiva(0.67, 0.25, 0.22);
const Vector3d attached(0.74, 0.345, 0.30);
const Vector3d mucosa(0.56, 0.165, 0.145);
const Vector3d vessel(0.36, 0.045, 0.055);

// Where on the gum a point is.
struct Zone {
  double along;   // mm, along the arch
  double below;   // mm, below the margin
  double loose;   // 0 attached gingiva .. 1 alveolar mucosa, on both sides of the mucogingival line
  double behind;  // 0 beside the teeth .. 1 on the retromolar pad
};

// Height (mm, y) of the mucogingival line: lowest below the canines, near the margin beside the premolars; it
// repeats the scallops of the margin, flatter. The tongue's side has more attached gingiva.
double mucogingival_line(const Arch::Foot& foot) {
  static const Profile outside(
      {{0, -13.6}, {6, -13.8}, {14, -13.9}, {21, -12.6}, {30, -12.2}, {40, -12.4}, {50, -11.6}, {58, -9.0}});
  static const Profile inside({{0, -14.6}, {14, -14.4}, {25, -13.8}, {40, -13.4}, {50, -12.5}, {58, -9.5}});
  const double along = std::abs(foot.along);
  const double side = smooth_step(-1.5, 1.5, foot.outward);
  return inside(along) + side * (outside(along) - inside(along));
}

Zone zone_at(const Gum& gum, const Arch::Foot& foot, const Vector3d& p) {
  const double wander = 0.35 * mottle(0.7 * p) + 0.25 * math::sin(1.05 * foot.along);
  const double above = p.y() - mucogingival_line(foot) + wander;
  return {.along = foot.along,
          .below = gum.below_margin(p),
          .loose = smooth_step(0.9, -1.1, above),
          .behind = smooth_step(52.5, 55.5, std::abs(foot.along))};
}

// Attached gingiva is dimpled like an orange's peel, its free margin and the mucosa are not. The dimples are
// so fine that they tilt the normal alone.
Vector3d stipple(const Zone& zone, const Vector3d& p) {
  const double dimpled = smooth_step(0.9, 2.2, zone.below) * (1.0 - zone.loose) * (1.0 - zone.behind);
  const Vector3d q = 4.0 * p;
  return (0.02 + 0.075 * dimpled) *
         Vector3d(mottle(q), mottle(q + Vector3d(7.1, 3.3, 1.9)), mottle(q + Vector3d(2.7, 9.1, 5.3)));
}

// Fine vessels that run up and branch: the lines where slow waves pass through zero.
double vessels(const Zone& zone, const Vector3d& p) {
  const double a =
      1.05 * zone.along + 1.1 * math::sin(0.55 * p.y() + 0.3 * zone.along) + 0.7 * math::sin(1.3 * p.y());
  const double b = 0.7 * zone.along - 0.9 * p.y() + 1.2 * math::sin(0.5 * zone.along + 0.8 * p.y());
  return std::max(bump(math::sin(a), 0.28), 0.7 * bump(math::sin(b), 0.25)) * (0.6 + 0.4 * mottle(0.6 * p));
}

Vector3d gum_colour(const Zone& zone, const Vector3d& p) {
  Vector3d colour = mixed(free_gingiva, attached, smooth_step(0.2, 2.0, zone.below));
  const Vector3d soft = mixed(mucosa, vessel, 0.6 * (1.0 - zone.behind) * vessels(zone, p));
  colour = mixed(colour, mixed(attached, mucosa, 0.4), zone.behind);
  colour = mixed(colour, soft, zone.loose);
  return colour * (1.0 + 0.05 * mottle(1.3 * p) + 0.04 * mottle(0.4 * p));
}

}  // namespace

Coat gum_coat(const Dentition& dentition, const Gum& gum, const Solid& solid) {
  const auto body = [&](const Vector3d& p) { return gum.distance(p); };
  Coat coat;
  for (const Vector3d& p : solid.points) {
    const Arch::Foot foot = dentition.arch.foot({p.x(), p.z()});
    const std::size_t tooth = dentition.nearest(foot.along);
    const auto scene = [&](const Vector3d& q) {
      return std::min(gum.distance(q), teeth_distance(dentition, tooth, q));
    };
    const Zone zone = zone_at(gum, foot, p);
    const Vector3d n = (gradient(body, p, 0.15).normalized() + stipple(zone, p)).normalized();
    const Vector3d colour = gum_colour(zone, p);
    coat.normals.push_back(n);
    coat.colours.push_back(shut_in(colour, openness(scene, p, n, surroundings), colour));
  }
  return coat;
}

}  // namespace fulcrum::content
