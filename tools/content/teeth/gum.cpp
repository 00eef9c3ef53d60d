#include "tools/content/teeth/gum.h"

#include <algorithm>
#include <cmath>

#include "tools/content/mesh/profile.h"
#include "tools/content/mesh/smooth.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr double margin_height = 0.7;  // mm above the cervical line, in the middle of a tooth
constexpr double end_papilla = 1.8;    // mm, behind the last tooth
constexpr double join = 2.6;           // mm, rounding between the sleeves of neighbouring teeth

// Height (mm) above the cervical line of the papilla between two teeth: to just below where they touch.
double papilla(const Tooth& a, const Tooth& b) {
  const auto to_contact = [](const Tooth& t) { return t.design.contact * t.crown_length; };
  return 0.5 * (to_contact(a) + to_contact(b)) * 0.54;
}

// How far (mm) the gum stands off a tooth, this far below its margin: a rounded edge, then free and attached
// gingiva.
double thickness(double below) {
  if (below < 0.0) return 0.25 + (1.1 - below) * below;
  // Further down it sinks into the ridge.
  const double deep = std::max(below - 2.5, 0.0);
  return 0.25 + 0.7 * (1.0 - std::exp(-below / 0.8)) - 0.03 * deep * deep;
}

// The neck of a tooth and the root below it, without the crown's bulge.
double neck_distance(const Tooth& tooth, const Vector3d& p_W) {
  Vector3d p = tooth.to_tooth(p_W);
  p.z() = std::clamp(p.z(), -2.0, 0.45 * tooth.crown_length);
  return tooth.design.body.distance(p);
}

}  // namespace

Gum::Gum(const Dentition& dentition) : dentition_(dentition) {}

Gum::Margin Gum::margin(const Vector3d& p_W, const Arch::Foot& foot) const {
  const auto& teeth = dentition_.teeth;
  const std::size_t here = dentition_.nearest(foot.along);
  const Tooth& tooth = teeth[here];
  const double offset = foot.along - tooth.along;
  const std::size_t last = teeth.size() - 1;
  const bool at_end = (here == 0 && offset < 0.0) || (here == last && offset > 0.0);
  const std::size_t beside = at_end ? here : (offset < 0.0 ? here - 1 : here + 1);
  const double part = std::min(std::abs(offset) / tooth.half_width, 1.0);
  const double half = 0.5 * smooth_step(0.3, 1.0, part);
  const double z = (1.0 - half) * tooth.to_tooth(p_W).z() + half * teeth[beside].to_tooth(p_W).z();
  const double tip = at_end ? end_papilla : papilla(tooth, teeth[beside]);
  Margin result;
  // Low along most of the tooth, then up to a rounded tip.
  const double rise = smooth_step(0.0, 1.0, std::pow(part, 1.55));
  result.below = margin_height + (tip - margin_height) * rise - z;
  result.to_teeth = neck_distance(tooth, p_W);
  for (const std::size_t other : {here - 1, here + 1}) {
    if (other > last) continue;  // before the first it has wrapped around
    result.to_teeth = smooth_min(result.to_teeth, neck_distance(teeth[other], p_W), join);
  }
  return result;
}

double Gum::ridge(const Vector3d& p_W, const Arch::Foot& foot) const {
  static const Profile top(
      {{0, -10.0}, {14, -10.5}, {25, -9.6}, {40, -8.3}, {48, -7.6}, {52, -5.8}, {55, -6.2}});
  static const Profile half_width({{0, 4.3}, {14, 5.0}, {25, 5.6}, {40, 6.9}, {48, 6.6}, {55, 5.0}});
  static const Profile shift(
      {{0, -1.6}, {14, -0.8}, {25, 0.3}, {40, 0.8}, {48, 0.4}, {55, 0.0}});  // outwards
  const double along = std::abs(foot.along);
  const double y = p_W.y();
  const double flare = 1.6 * smooth_step(-9.0, -19.0, y);
  const double sides = std::abs(foot.outward - shift(along)) - half_width(along) - flare;
  const double body = smooth_max(sides, y - top(along), 5.0);
  return smooth_max(body, base - y, 2.2);
}

double Gum::distance(const Vector3d& p_W) const {
  const Arch::Foot foot = dentition_.arch.foot({p_W.x(), p_W.z()});
  const double hull = ridge(p_W, foot);
  if (hull > 12.0) return hull;
  const Margin m = margin(p_W, foot);
  // The necks are formulas without an end: inside the ridge, well above its underside, they are cut.
  const double sleeve = smooth_max(m.to_teeth - thickness(m.below), base + 4.0 - p_W.y(), 1.0);
  return smooth_min(sleeve, hull, 3.0);
}

double Gum::below_margin(const Vector3d& p_W) const {
  return margin(p_W, dentition_.arch.foot({p_W.x(), p_W.z()})).below;
}

}  // namespace fulcrum::content
