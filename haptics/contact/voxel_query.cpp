#include "haptics/contact/voxel_query.h"

#include <cmath>
#include <utility>

namespace fulcrum {
namespace {

constexpr std::size_t kBrickVoxels = kBrickCells * kBrickCells * kBrickCells;
constexpr int kMarch = 8;  // voxels, how far inside the surface is looked for

}  // namespace

VoxelQuery::VoxelQuery(std::shared_ptr<const Pointshell> shell_T,
                       std::shared_ptr<const DistanceField> field_W)
    : shell_(std::move(shell_T)),
      field_(std::move(field_W)),
      origin_W_(field_->data().origin),
      voxel_(field_->voxel_m()) {
  const FieldData& data = field_->data();
  std::size_t slots = 0;
  for (const std::int32_t slot : data.brick_slot) slots += slot != kNoBrick ? 1 : 0;
  state_.assign(slots * kBrickVoxels, State::free);
  std::size_t brick = 0;
  for (int bz = 0; bz < data.bricks[2]; ++bz) {
    for (int by = 0; by < data.bricks[1]; ++by) {
      for (int bx = 0; bx < data.bricks[0]; ++bx, ++brick) {
        if (data.brick_slot[brick] == kNoBrick) continue;
        State* state = &state_[static_cast<std::size_t>(data.brick_slot[brick]) * kBrickVoxels];
        for (int z = 0; z < kBrickCells; ++z) {
          for (int y = 0; y < kBrickCells; ++y) {
            for (int x = 0; x < kBrickCells; ++x) {
              const Vec3 cell(kBrickCells * bx + x + 0.5, kBrickCells * by + y + 0.5,
                              kBrickCells * bz + z + 0.5);
              const FieldSample sample = field_->sample(origin_W_ + voxel_ * cell);
              // The plane that passes a cube at this distance from its centre touches a corner.
              const double half = 0.5 * voxel_ * sample.gradient.lpNorm<1>();
              *state++ = std::abs(sample.distance) <= half ? State::surface
                         : sample.distance < 0             ? State::inside
                                                           : State::free;
            }
          }
        }
      }
    }
  }
}

VoxelQuery::State VoxelQuery::at(const Vec3& p_W, Vec3& centre_W) const noexcept {
  const FieldData& data = field_->data();
  const Vec3 cell = ((p_W - origin_W_) / voxel_).array().floor();
  centre_W = origin_W_ + voxel_ * (cell + Vec3::Constant(0.5));
  std::array<std::size_t, 3> brick{}, within{};
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const double at = cell[static_cast<Eigen::Index>(axis)];
    if (!(at >= 0 && at < static_cast<double>(kBrickCells) * data.bricks[axis])) return State::free;
    const auto whole = static_cast<std::size_t>(at);
    brick[axis] = whole / kBrickCells;
    within[axis] = whole % kBrickCells;
  }
  const auto nx = static_cast<std::size_t>(data.bricks[0]), ny = static_cast<std::size_t>(data.bricks[1]);
  const std::int32_t slot = data.brick_slot[(brick[2] * ny + brick[1]) * nx + brick[0]];
  if (slot == kNoBrick) return field_->distance(p_W) < 0 ? State::inside : State::free;
  return state_[static_cast<std::size_t>(slot) * kBrickVoxels +
                (within[2] * kBrickCells + within[1]) * kBrickCells + within[0]];
}

ContactQuery::Outcome VoxelQuery::run(const Pose& X_WT, ContactSet& set) const noexcept {
  set.clear();
  ContactQuery::Outcome outcome;
  const Mat3 R_WT = X_WT.q.toRotationMatrix();
  for (std::size_t i = 0; i < shell_->size(); ++i) {
    const Vec3 p_W = R_WT * shell_->positions[i] + X_WT.p;
    Vec3 centre_W;
    State state = at(p_W, centre_W);
    if (state == State::free) continue;
    const Vec3 out_W = -(R_WT * shell_->normals[i]);
    Vec3 seen_W = p_W;
    for (int n = 0; n < kMarch && state == State::inside; ++n) {
      seen_W += voxel_ * out_W;
      state = at(seen_W, centre_W);
    }
    outcome.in_band &= state != State::inside;
    const double depth = out_W.dot(centre_W - p_W);
    if (depth <= 0) continue;
    set.add({static_cast<std::uint32_t>(i), p_W, out_W, depth, Overlap::of(shell_->areas_m2[i], depth, p_W)});
  }
  outcome.complete = set.complete();
  return outcome;
}

}  // namespace fulcrum
