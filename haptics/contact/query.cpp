#include "haptics/contact/query.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

namespace fulcrum {
namespace {

// Of single precision, in the sums that take a place to cells and in the look-up.
constexpr double kUnitRoundoff = 0x1p-24, kRoundings = 16;

double rounding_over(double metres) {
  return kRoundings * kUnitRoundoff * metres;
}

double beyond_band_error(const DistanceField& field) {
  return field.voxel_m() * field.voxel_m() / (4 * field.band_m()) + 0.5 * field.quantum_m();
}

double overestimate_of(const DistanceField& field) {
  return std::max(field.error_bound_m(), beyond_band_error(field));
}

// (bricks) m: by how much the field, by the errors measured at bake, may say too much at a place in the brick
// and too little at another no farther from it than a brick's edge.
std::vector<float> slack_of_bricks(const DistanceField& field, double rounding) {
  const FieldData& data = field.data();
  const auto at = [&](std::int32_t x, std::int32_t y, std::int32_t z) {
    return static_cast<std::size_t>((z * data.bricks[1] + y) * data.bricks[0] + x);
  };
  std::vector<float> own(data.brick_slot.size(), 0.0f);
  for (std::size_t i = 0; i < own.size(); ++i)
    if (data.brick_slot[i] != kNoBrick)
      own[i] = data.slot_error_m[static_cast<std::size_t>(data.brick_slot[i])];
  // The largest of three in a row, along each axis in turn: of all the bricks around.
  std::vector<float> around = own, before;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    before = around;
    for (std::int32_t z = 0; z < data.bricks[2]; ++z) {
      for (std::int32_t y = 0; y < data.bricks[1]; ++y) {
        for (std::int32_t x = 0; x < data.bricks[0]; ++x) {
          std::array<std::int32_t, 3> next{x, y, z};
          if (++next[axis] == data.bricks[axis]) continue;
          const std::size_t a = at(x, y, z), b = at(next[0], next[1], next[2]);
          around[a] = std::max(around[a], before[b]);
          around[b] = std::max(around[b], before[a]);
        }
      }
    }
  }
  const auto beyond = static_cast<float>(beyond_band_error(field));
  for (std::size_t i = 0; i < around.size(); ++i)
    around[i] += std::max(own[i], beyond) + static_cast<float>(rounding);
  return around;
}

// Turns patches into contacts, all but their normals. S is the shell's frame.
struct Collector {
  const Pointshell& shell_S;
  Mat3 R_WS;
  Vec3 p_WS;
  std::uint32_t first_point;
  double band;  // m
  ContactSet& set;
  float margin;
  bool in_band = true;

  Overlap in_W(Overlap overlap) const {
    overlap.centred = R_WS * overlap.centred + overlap.volume * p_WS;
    return overlap;
  }

  // overlap: in S.
  Contact contact(const PatchHit& hit, unsigned lane, const Overlap& overlap) const {
    const std::uint32_t point = hit.first + lane;
    return {first_point + point, R_WS * shell_S.positions[point] + p_WS, Vec3::Zero(),
            -static_cast<double>(hit.distance[lane]), in_W(overlap)};
  }

  float take(const PatchHit& hit) {
    auto deepest = static_cast<unsigned>(std::countr_zero(hit.touching));
    float least = hit.distance[deepest];
    Overlap overlap;
    const bool one_by_one = set.complete();
    for (std::uint32_t left = hit.touching; left != 0; left &= left - 1) {
      const auto lane = static_cast<unsigned>(std::countr_zero(left));
      const Overlap own =
          Overlap::of(shell_S.areas_m2[hit.first + lane], -static_cast<double>(hit.distance[lane]),
                      shell_S.positions[hit.first + lane]);
      if (one_by_one) set.add(contact(hit, lane, own));
      if (hit.distance[lane] < least) {
        least = hit.distance[lane];
        deepest = lane;
      }
      overlap += own;
    }
    const double depth = -static_cast<double>(least);
    if (!one_by_one && !set.absorb(first_point + hit.first + deepest, depth,
                                   in_W(overlap)))  // as one by one would end up, sooner
      set.add(contact(hit, deepest, overlap));
    in_band &= depth <= band;
    return margin;
  }
};

// The least fraction of a motion that a point near the scene allows.
struct Advance {
  const Pointshell& shell;
  Vec3 centre;   // of the turn, in the shell's frame
  double drift;  // m, how far the centre itself moves there
  double arm;    // m, no point that matters is ever farther from it
  double travel, turn, allowance, known, overestimate, farthest;
  double fraction = 1;

  // Points beyond cannot lower the fraction that has been found: they are farther than they travel by it,
  // less the allowance where all have it.
  float margin() const {
    const double spared = std::isinf(known) ? allowance : 0.0;
    return static_cast<float>(fraction * farthest - spared + overestimate);
  }

  float take(const PatchHit& hit) {
    for (std::uint32_t left = hit.touching; left != 0; left &= left - 1) {
      const auto lane = static_cast<unsigned>(std::countr_zero(left));
      const double distance = static_cast<double>(hit.distance[lane]);
      const double safe = std::max(distance - overestimate, 0.0);
      const double room =
          distance < known ? safe + allowance : std::min(safe + allowance, std::max(safe, known));
      if (fraction * farthest <= room) continue;
      const double own = (shell.positions[hit.first + lane] - centre).norm();
      const double reach = travel + turn * std::min(own + drift, arm);
      if (fraction * reach > room) fraction = room / reach;
    }
    return margin();
  }
};

template <class Taker>
void walk_into(ShellWalk walk, Taker& taker) noexcept {
  walk.taker = &taker;
  walk.found = [](void* to, const PatchHit& hit) noexcept { return static_cast<Taker*>(to)->take(hit); };
  walk_shell(walk);
}

}  // namespace

ContactQuery::ContactQuery(const std::shared_ptr<const Pointshell>& shell_T,
                           std::shared_ptr<const DistanceField> field_W, Normals normals)
    : ContactQuery(shell_T, std::move(field_W), normals, Points::of_tool, 0, shell_T->max_radius_m) {}

ContactQuery ContactQuery::of_scene(std::shared_ptr<const Pointshell> shell_W,
                                    std::shared_ptr<const DistanceField> field_T, Normals normals,
                                    std::uint32_t first_point, double tool_radius) {
  return {std::move(shell_W), std::move(field_T), normals, Points::of_scene, first_point, tool_radius};
}

ContactQuery::ContactQuery(std::shared_ptr<const Pointshell> shell,
                           std::shared_ptr<const DistanceField> field, Normals normals, Points points,
                           std::uint32_t first_point, double tool_radius)
    : shell_(std::move(shell)),
      field_(std::move(field)),
      normals_(normals),
      points_(points),
      first_point_(first_point),
      tool_radius_(tool_radius),
      tree_(build_sphere_tree(*shell_)),
      view_(view_of(*field_)),
      rounding_(rounding_over(2 * tree_.patch_radius + field_->voxel_m() + field_->band_m())),
      rounding_far_(rounding_over(field_->grid_box().sizes().maxCoeff() + 2 * shell_->max_radius_m)),
      overestimate_(overestimate_of(*field_) + rounding_far_),
      brick_slack_(slack_of_bricks(*field_, 2 * rounding_far_)) {
  simd_target();  // the first call finds out what the processor has
}

ShellWalk ContactQuery::walk(double margin) const noexcept {
  ShellWalk walk{};
  walk.tree = &tree_;
  walk.field = view_;
  const double cells_per_m = 1 / field_->voxel_m();
  const Pose X_FS = shell_in_field();
  const Mat3 turn = X_FS.q.toRotationMatrix() * cells_per_m;
  const Vec3 shift = (X_FS.p - field_->data().origin) * cells_per_m;
  for (Eigen::Index row = 0; row < 3; ++row) {
    for (Eigen::Index column = 0; column < 3; ++column)
      walk.turn[static_cast<std::size_t>(3 * row + column)] = turn(row, column);
    walk.shift[static_cast<std::size_t>(row)] = shift[row];
  }
  walk.margin = static_cast<float>(margin);
  // At the node's centre the field may say too much, at the point too little.
  walk.slack = static_cast<float>(overestimate_ + field_->error_bound_m() + rounding_far_);
  walk.brick_slack = brick_slack_.data();
  walk.brick_edge = static_cast<float>(kBrickCells * field_->voxel_m() - rounding_far_);
  return walk;
}

ContactQuery::Outcome ContactQuery::run(const Pose& X_WT, ContactSet& set, double margin) noexcept {
  set.clear();
  return add(X_WT, set, margin);
}

ContactQuery::Outcome ContactQuery::add(const Pose& X_WT, ContactSet& set, double margin) noexcept {
  X_WT_ = X_WT;
  const bool of_tool = points_ == Points::of_tool;
  Collector collector{.shell_S = *shell_,
                      .R_WS = of_tool ? X_WT.q.toRotationMatrix() : Mat3(Mat3::Identity()),
                      .p_WS = of_tool ? X_WT.p : Vec3(Vec3::Zero()),
                      .first_point = first_point_,
                      .band = field_->band_m(),
                      .set = set,
                      .margin = static_cast<float>(margin)};
  walk_into(walk(margin), collector);
  find_normals(set.contacts());
  return {set.complete(), collector.in_band};
}

// After the walk: of what is taken together, only the deepest needs one.
void ContactQuery::find_normals(std::span<Contact> contacts) const noexcept {
  const auto own = std::find_if(contacts.begin(), contacts.end(),
                                [this](const Contact& contact) { return contact.point >= first_point_; });
  contacts = contacts.subspan(static_cast<std::size_t>(own - contacts.begin()));
  const bool of_tool = points_ == Points::of_tool;
  const Pose X_FW = of_tool ? Pose{} : X_WT_.inverse();
  // What points out of the tool points into the scene.
  const Mat3 R_out = of_tool ? Mat3(Mat3::Identity()) : Mat3(-X_WT_.q.toRotationMatrix());
  for (; !contacts.empty(); contacts = contacts.subspan(std::min(kBlock, contacts.size()))) {
    const std::size_t count = std::min(kBlock, contacts.size());
    NormalBatch batch{};
    std::array<Vec3, kBlock> p_F;
    for (std::size_t i = 0; i < count; ++i) {
      p_F[i] = X_FW * contacts[i].p_W;
      const Vec3 cells = (p_F[i] - field_->data().origin) / field_->voxel_m();
      batch.x[i] = static_cast<float>(cells.x());
      batch.y[i] = static_cast<float>(cells.y());
      batch.z[i] = static_cast<float>(cells.z());
    }
    look_up_normals(view_, normals_, batch);
    for (std::size_t i = 0; i < count; ++i) {
      const bool known = (batch.known >> i & 1u) != 0;
      const Vec3 nhat_F = known ? Vec3(static_cast<double>(batch.nx[i]), static_cast<double>(batch.ny[i]),
                                       static_cast<double>(batch.nz[i]))
                                : field_->sample(p_F[i]).gradient;
      contacts[i].nhat_W = R_out * nhat_F;
    }
  }
}

double ContactQuery::safe_fraction(double travel, double turn, double allowance,
                                   double known) const noexcept {
  // A point of the scene that the tool does not come to within its reach cannot be entered.
  const bool of_tool = points_ == Points::of_tool;
  const double arm = of_tool ? tool_radius_ : tool_radius_ + travel;
  const double farthest = travel + turn * arm;
  if (farthest <= std::min(allowance, known)) return 1.0;
  Advance advance{.shell = *shell_,
                  .centre = of_tool ? Vec3(Vec3::Zero()) : X_WT_.p,
                  .drift = of_tool ? 0.0 : travel,
                  .arm = arm,
                  .travel = travel,
                  .turn = turn,
                  .allowance = allowance,
                  .known = known,
                  .overestimate = overestimate_,
                  .farthest = farthest};
  walk_into(walk(static_cast<double>(advance.margin())), advance);
  return advance.fraction;
}

}  // namespace fulcrum
