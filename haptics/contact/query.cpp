#include "haptics/contact/query.h"

#include <algorithm>
#include <bit>
#include <utility>

namespace fulcrum {
namespace {

// Of single precision, in the sums that take a point to cells and in the look-up.
constexpr double kUnitRoundoff = 0x1p-24, kRoundings = 16;

double rounding_of(const Pointshell& shell, const DistanceField& field) {
  const double reach = field.grid_box().sizes().maxCoeff() + 2 * shell.max_radius_m;
  return kRoundings * kUnitRoundoff * reach;
}

double overestimate_of(const DistanceField& field) {
  const double beyond_band =
      field.voxel_m() * field.voxel_m() / (4 * field.band_m()) + 0.5 * field.quantum_m();
  return std::max(field.error_bound_m(), beyond_band);
}

// Turns patches into contacts.
struct Collector {
  const Pointshell& shell_T;
  const DistanceField& field_W;
  Mat3 R_WT;
  Vec3 p_WT;
  ContactSet& set;
  double margin;
  bool in_band = true;

  Contact contact(const PatchHit& hit, unsigned lane, double area) const {
    const std::uint32_t point = hit.first + lane;
    const Vec3 p_W = R_WT * shell_T.positions[point] + p_WT;
    const Vec3 nhat_W = (hit.guessed >> lane & 1u) != 0
                            ? field_W.sample(p_W).gradient
                            : Vec3(static_cast<double>(hit.nx[lane]), static_cast<double>(hit.ny[lane]),
                                   static_cast<double>(hit.nz[lane]));
    // Stiff contact feels the rounding of single precision: depths are looked up again in double.
    return {point, p_W, nhat_W, -field_W.distance(p_W), area};
  }

  void take(const PatchHit& hit) {
    auto deepest = static_cast<unsigned>(std::countr_zero(hit.touching));
    float least = hit.distance[deepest];
    double area = 0;
    const bool one_by_one = set.complete();
    for (std::uint32_t left = hit.touching; left != 0; left &= left - 1) {
      const auto lane = static_cast<unsigned>(std::countr_zero(left));
      const double own = shell_T.areas_m2[hit.first + lane];
      if (one_by_one) {
        const Contact each = contact(hit, lane, own);
        if (-each.depth < margin) set.add(each);
      }
      if (hit.distance[lane] < least) {
        least = hit.distance[lane];
        deepest = lane;
      }
      area += own;
    }
    const double depth = -static_cast<double>(least);
    if (!one_by_one && !set.absorb(hit.first + deepest, depth, area))  // as one by one would end up, sooner
      set.add(contact(hit, deepest, area));
    in_band &= depth <= field_W.band_m();
  }
};

// The least fraction of a motion that a point near the scene allows.
struct Advance {
  const Pointshell& shell_T;
  double travel, turn, allowance, overestimate;
  double fraction = 1;

  void take(const PatchHit& hit) {
    for (std::uint32_t left = hit.touching; left != 0; left &= left - 1) {
      const auto lane = static_cast<unsigned>(std::countr_zero(left));
      const double reach = travel + turn * shell_T.positions[hit.first + lane].norm();
      const double distance = static_cast<double>(hit.distance[lane]);
      const double room = std::max(distance - overestimate, 0.0) + allowance;
      if (reach > room) fraction = std::min(fraction, room / reach);
    }
  }
};

template <class Taker>
void walk_into(ShellWalk walk, Taker& taker) noexcept {
  walk.taker = &taker;
  walk.found = [](void* to, const PatchHit& hit) noexcept { static_cast<Taker*>(to)->take(hit); };
  walk_shell(walk);
}

}  // namespace

ContactQuery::ContactQuery(std::shared_ptr<const Pointshell> shell_T,
                           std::shared_ptr<const DistanceField> field_W)
    : shell_(std::move(shell_T)),
      field_(std::move(field_W)),
      tree_(build_sphere_tree(*shell_)),
      view_(view_of(*field_)),
      rounding_(rounding_of(*shell_, *field_)),
      overestimate_(overestimate_of(*field_) + rounding_) {
  simd_target();  // the first call finds out what the processor has
}

ShellWalk ContactQuery::walk_at(const Pose& X_WT, double margin) const noexcept {
  ShellWalk walk{};
  walk.tree = &tree_;
  walk.field = view_;
  const double cells_per_m = 1 / field_->voxel_m();
  const Mat3 turn = X_WT.q.toRotationMatrix() * cells_per_m;
  const Vec3 shift = (X_WT.p - field_->data().origin) * cells_per_m;
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column)
      walk.turn[static_cast<std::size_t>(3 * row + column)] = static_cast<float>(turn(row, column));
    walk.shift[static_cast<std::size_t>(row)] = static_cast<float>(shift[row]);
  }
  walk.margin = static_cast<float>(margin);
  // At the node's centre the field may say too much, at the point too little.
  walk.slack = static_cast<float>(overestimate_ + field_->error_bound_m() + rounding_);
  return walk;
}

ContactQuery::Outcome ContactQuery::run(const Pose& X_WT, ContactSet& set, double margin) noexcept {
  set.clear();
  X_WT_ = X_WT;
  Collector collector{*shell_, *field_, X_WT.q.toRotationMatrix(), X_WT.p, set, margin};
  ShellWalk walk = walk_at(X_WT, margin + rounding_);
  walk.normals = true;
  walk_into(walk, collector);
  return {set.complete(), collector.in_band};
}

double ContactQuery::safe_fraction(double travel, double turn, double allowance) const noexcept {
  const double farthest = travel + turn * shell_->max_radius_m;
  if (farthest <= allowance) return 1.0;
  Advance advance{*shell_, travel, turn, allowance, overestimate_};
  // Points beyond are farther than any of them travels.
  walk_into(walk_at(X_WT_, farthest - allowance + overestimate_), advance);
  return advance.fraction;
}

}  // namespace fulcrum
