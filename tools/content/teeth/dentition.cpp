#include "tools/content/teeth/dentition.h"

// Inclinations follow L. Andrews, "The six keys to normal occlusion", American Journal of Orthodontics 62(3),
// 1972, in their course along the arch: incisors lean out, molars lean in, every crown tips a little to
// mesial. They are less than his figures for the facial surfaces, since the shapes of the crowns lean by
// themselves.

#include <algorithm>
#include <cmath>
#include <utility>

#include "haptics/math/functions.h"
#include "tools/content/mesh/solid.h"
#include "tools/content/teeth/tooth_designs.h"
#include "tools/content/teeth/tooth_table.h"
#include "tools/content/teeth/variation.h"

namespace fulcrum::content {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector2d;
using Eigen::Vector3d;

struct Stance {
  double inward;  // rad, of the crown to lingual
  double mesial;  // rad, of the crown to mesial
  double turn;    // rad, about its own axis, mesial side outwards
};

constexpr std::array<Stance, 7> stances{{
    {-13 * degree, 1 * degree, 1.5 * degree},
    {-11 * degree, 1 * degree, -3 * degree},
    {-2 * degree, 3 * degree, 3 * degree},
    {5 * degree, 2 * degree, -2 * degree},
    {8 * degree, 2 * degree, 2 * degree},
    {12 * degree, 2 * degree, 1 * degree},
    {14 * degree, 3 * degree, -1 * degree},
}};

constexpr double contact_overlap = 0.03;  // mm: two teeth in contact are one body there

Vector3d in_space(const Vector2d& xz, double y) {
  return {xz.x(), y, xz.y()};
}

// On the jaw's right, where onward is mesial.
void stand(Tooth* tooth, const Stance& stance, const Variation& own, const Arch& arch, double along) {
  const Arch::Place at = arch.at(along);
  const Vector3d up = Vector3d::UnitY();
  const Vector3d line = in_space(at.onward, 0.0);
  const Vector3d out = in_space(at.outward, 0.0);
  const Vector3d mesial0 = math::cos(stance.turn) * line + math::sin(stance.turn) * out;
  const Vector3d buccal0 = math::cos(stance.turn) * out - math::sin(stance.turn) * line;
  const Vector3d occlusal1 = math::cos(stance.inward) * up - math::sin(stance.inward) * buccal0;
  const Vector3d buccal = math::cos(stance.inward) * buccal0 + math::sin(stance.inward) * up;
  tooth->R_WT.col(0) = math::cos(stance.mesial) * mesial0 - math::sin(stance.mesial) * occlusal1;
  tooth->R_WT.col(1) = buccal;
  tooth->R_WT.col(2) = math::cos(stance.mesial) * occlusal1 + math::sin(stance.mesial) * mesial0;
  tooth->along = along;
  const double length = tooth->size * tooth->crown_length;
  const double pivot = tooth->design.contact * length;
  tooth->p_WT =
      in_space(at.p + own.outward * at.outward, occlusal_height(along) + own.up - (length - pivot)) -
      pivot * tooth->R_WT.col(2);
}

Tooth mirrored(Tooth tooth) {
  tooth.number -= 10;
  tooth.along = -tooth.along;
  tooth.R_WT.row(0) *= -1.0;
  tooth.p_WT.x() *= -1.0;
  return tooth;
}

}  // namespace

double contact_depth(const Tooth& a, const Tooth& b) {
  const Vector3d middle = 0.5 * (a.to_world({0, 0, a.design.contact * a.crown_length}) +
                                 b.to_world({0, 0, b.design.contact * b.crown_length}));
  const Vector3d between = 0.5 * (a.p_WT + b.p_WT);
  const Vector3d line = (b.p_WT - a.p_WT).cwiseProduct(Vector3d(1, 0, 1)).normalized();
  const Vector3d across(-line.z(), 0.0, line.x());
  double least = 1e3;
  for (double u = -2.0; u <= 2.0; u += 0.25) {
    for (double v = -2.5; v <= 2.5; v += 0.5) {
      for (double w = -2.5; w <= 2.0; w += 0.5) {
        const Vector3d p = 0.5 * (middle + Vector3d(between.x(), middle.y(), between.z())) + u * line +
                           v * across + w * Vector3d::UnitY();
        least = std::min(least, std::max(a.distance(p), b.distance(p)));
      }
    }
  }
  return -least;
}

Dentition make_dentition() {
  Dentition result;
  Variations variations;
  std::array<Tooth, 2> before;  // the neighbours to mesial, on the right and on the left
  for (int place = 1; place <= 7; ++place) {
    const ToothSize& size = tooth_table[static_cast<std::size_t>(place - 1)];
    for (const bool left : {false, true}) {
      const Variation own = variations.next();
      Tooth tooth;
      tooth.number = 40 + place;
      tooth.design = tooth_design(place);
      tooth.design.relief.phase = own.phase;
      tooth.size = own.size;
      tooth.crown_length = size.crown_length;
      tooth.half_width = 0.5 * own.size * size.width;
      Stance stance = stances[static_cast<std::size_t>(place - 1)];
      stance.inward += own.inward;
      stance.mesial += own.mesial;
      stance.turn += own.turn;
      const auto at = [&](double along) {
        stand(&tooth, stance, own, result.arch, -along);
        return left ? mirrored(tooth) : tooth;
      };
      // Back along the arch until it just touches the one before it; the first, across the middle, its own
      // image, and its neighbour there then touches it.
      const bool first = place == 1 && !left;
      double near = place == 1 ? 0.0 : std::abs(before[left].along);
      double far = near + 1.5 * size.width + 2.0;
      for (int halving = 0; halving < 14; ++halving) {
        const double half = 0.5 * (near + far);
        const Tooth there = at(half);
        const double depth = contact_depth(there, first ? mirrored(there) : before[left]);
        (depth > contact_overlap ? near : far) = half;
      }
      tooth = at(far);
      result.teeth[static_cast<std::size_t>(left ? 6 + place : 7 - place)] = tooth;
      if (first) before[1] = tooth;
      before[left] = std::move(tooth);
    }
  }
  return result;
}

const Tooth& Dentition::tooth(int number) const {
  return *std::find_if(
      teeth.begin(), teeth.end(), [&](const Tooth& t) { return t.number == number; });
}

std::size_t Dentition::nearest(double along) const {
  std::size_t best = 0;
  double least = 1e9;
  for (std::size_t i = 0; i < teeth.size(); ++i) {
    const double off = std::abs(along - teeth[i].along) - teeth[i].half_width;
    if (off < least) {
      least = off;
      best = i;
    }
  }
  return best;
}

}  // namespace fulcrum::content
