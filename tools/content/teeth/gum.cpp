#include "tools/content/teeth/gum.h"

#include <algorithm>
#include <cmath>

#include "haptics/math/functions.h"
#include "tools/content/mesh/profile.h"
#include "tools/content/mesh/smooth.h"

namespace fulcrum::content {
namespace {

using Eigen::Vector3d;

constexpr double margin_height = 0.7;  // mm above the cervical line, in the middle of a tooth
constexpr double end_papilla = 1.8;    // mm, behind the last tooth
constexpr double join = 2.6;           // mm, rounding between the sleeves of neighbouring teeth
constexpr double roll = 0.8;           // mm, rounding of the free margin

// Height (mm) above the cervical line of the papilla between two teeth: to just below where they touch.
double papilla(const Tooth& a, const Tooth& b) {
  const auto to_contact = [](const Tooth& t) { return t.design.contact * t.crown_length; };
  return 0.5 * (to_contact(a) + to_contact(b)) * 0.66;
}

// Of the margin, from 0 in the middle of a tooth to 1 at the papilla's rounded tip.
double scallop(double part) {
  return smooth_step(0.0, 1.0, math::pow(std::clamp(part, 0.0, 1.0), 1.55));
}

// How far (mm) the gum stands off a tooth, this far below its margin: the free gingiva, a shallow groove, the
// attached gingiva, which further down, this far under the cervical line, sinks into the ridge.
double thickness(double below, double under_neck) {
  const double deep = std::max(under_neck - 1.8, 0.0);
  return 0.45 + 0.45 * smooth_step(-0.4, 2.2, below) - 0.06 * bump(below - 2.1, 0.6) - 0.03 * deep * deep;
}

// The neck of a tooth and the root below it, without the crown's bulge.
double neck_distance(const Tooth& tooth, const Vector3d& p_W) {
  Vector3d p = tooth.to_tooth(p_W);
  p.z() = std::clamp(p.z(), -2.0, 0.6 * tooth.crown_length);
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
  const double side = at_end ? tooth.half_width
                             : std::abs(teeth[beside].along - tooth.along) * tooth.half_width /
                                   (tooth.half_width + teeth[beside].half_width);
  const double part = std::min(std::abs(offset) / side, 1.0);
  const double half = 0.5 * smooth_step(0.3, 1.0, part);
  const double z = (1.0 - half) * tooth.to_tooth(p_W).z() + half * teeth[beside].to_tooth(p_W).z();
  const double rise = (at_end ? end_papilla : papilla(tooth, teeth[beside])) - margin_height;
  Margin result;
  result.under_neck = -z;
  result.below = margin_height + rise * scallop(part) - z;
  constexpr double little = 0.01;
  result.slope = rise * (scallop(part + little) - scallop(part - little)) / (2.0 * little * side);
  // Deep down neighbouring roots are one ridge: from the inside of the arch they would look like pleats.
  const double wide = join + 2.5 * smooth_step(1.5, 6.0, result.below);
  result.to_teeth = 1e3;
  for (std::size_t i = here < 2 ? 0 : here - 2; i <= std::min(here + 2, last); ++i)
    result.to_teeth = smooth_min(result.to_teeth, neck_distance(teeth[i], p_W), wide);
  return result;
}

// Folds of mucosa in the middle of the jaw, to the lip and to the tongue: how far (mm) they stand out.
double frenulum(const Vector3d& p_W, const Arch::Foot& foot) {
  const double wander = foot.along - 0.35 * math::sin(0.45 * p_W.y());
  const double above_base = smooth_step(-20.4, -17.8, p_W.y());
  if (foot.outward > 0.0) return 1.1 * bump(wander, 0.65) * smooth_step(-12.5, -16.5, p_W.y()) * above_base;
  return 0.9 * bump(wander, 0.7) * smooth_step(-14.0, -17.5, p_W.y()) * above_base;
}

double Gum::ridge(const Vector3d& p_W, const Arch::Foot& foot) const {
  // Behind the last tooth, from 52 mm on, the pear of the retromolar pad.
  static const Profile top({{0, -9.0},
                            {14, -9.8},
                            {25, -9.6},
                            {40, -8.3},
                            {48, -7.6},
                            {52, -6.4},
                            {56, -5.2},
                            {58, -4.9},
                            {60, -4.9}});
  static const Profile half_width(
      {{0, 5.1}, {14, 5.4}, {25, 5.6}, {40, 6.9}, {48, 6.6}, {52, 5.4}, {56, 4.5}, {58, 4.0}, {60, 4.0}});
  static const Profile shift(
      {{0, -2.3}, {14, -1.1}, {25, 0.3}, {40, 0.8}, {48, 0.4}, {55, 0.0}});  // outwards
  const double along = std::abs(foot.along);
  const double y = p_W.y();
  const double flare = 1.6 * smooth_step(-9.0, -19.0, y);
  const double sides =
      std::abs(foot.outward - shift(along)) - half_width(along) - flare - frenulum(p_W, foot);
  const double body = smooth_max(sides, y - top(along), 5.0);
  return smooth_max(body, base - y, 2.2);
}

double Gum::distance(const Vector3d& p_W) const {
  const Arch::Foot foot = dentition_.arch.foot({p_W.x(), p_W.z()});
  const double hull = ridge(p_W, foot);
  if (hull > 12.0) return hull;
  const Margin m = margin(p_W, foot);
  // The necks are formulas without an end: inside the ridge, well above its underside, they are cut.
  const double side = m.to_teeth - thickness(m.below, m.under_neck);
  const double rolled = smooth_max(side, -m.below / math::hypot(1.0, m.slope), roll);
  const double sleeve = smooth_max(rolled, base + 4.0 - p_W.y(), 1.0);
  return smooth_min(sleeve, hull, 3.0);
}

double Gum::below_margin(const Vector3d& p_W) const {
  return margin(p_W, dentition_.arch.foot({p_W.x(), p_W.z()})).below;
}

}  // namespace fulcrum::content
