#include "haptics/bake/field_bake.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <string>

#include "haptics/bake/brick_bake.h"
#include "haptics/bake/parallel.h"
#include "haptics/bake/resolution.h"
#include "haptics/bake/sentence.h"
#include "haptics/bake/triangle_distance.h"
#include "haptics/bake/union_distance.h"
#include "haptics/bake/wall_thickness.h"
#include "haptics/math/functions.h"

namespace fulcrum {
namespace {

constexpr double kLargestField = 2e9;  // bytes
constexpr int kBlockBricks = 4;  // bricks along a block's edge; a block shares its list of near components
constexpr double kClassifyShare = 0.1;  // of the whole work, for the progress

double brick_radius(double voxel_m) {
  return std::numbers::sqrt3 / 2.0 * kBrickCells * voxel_m;
}

// Bricks over the solid's bounds, grown by the band.
std::optional<Error> lay_grid(FieldData& field) {
  const double brick_m = kBrickCells * field.voxel_m;
  const double margin = field.band_m + field.voxel_m;
  const Vec3 size = field.surface_box.sizes() + Vec3::Constant(2.0 * margin);
  const Vec3 bricks = (size / brick_m).array().ceil();
  constexpr double kBytesPerBrick = sizeof(std::int32_t) + sizeof(float);
  if (bricks.prod() * kBytesPerBrick > kLargestField) {
    const double scale = math::cbrt(bricks.prod() * kBytesPerBrick / kLargestField);
    return Error{"A distance field of " + spell_mm(field.voxel_m) + " voxels over " +
                 spell_mm(size.maxCoeff()) + " would have too many bricks to index: use a voxel of " +
                 spell_mm(1.05 * scale * field.voxel_m) + " or more, or remove far-away parts."};
  }
  field.origin = field.surface_box.center() - 0.5 * brick_m * bricks;
  for (std::size_t axis = 0; axis < 3; ++axis)
    field.bricks[axis] = static_cast<std::int32_t>(bricks[static_cast<Eigen::Index>(axis)]);
  const auto count = static_cast<std::size_t>(bricks.prod());
  field.brick_slot.assign(count, kNoBrick);
  field.centre_m.assign(count, 0.0f);
  return std::nullopt;
}

class Baker {
public:
  Baker(const Solid& solid, const TriangleDistance& exact, const FieldDesc& desc, FieldData& field)
      : solid_(solid), exact_(exact), threads_(desc.threads), field_(field) {
    for (std::size_t axis = 0; axis < 3; ++axis)
      blocks_[axis] = (field.bricks[axis] + kBlockBricks - 1) / kBlockBricks;
  }

  // The centres of all bricks, and which of them are in band.
  void classify(const std::function<void(double)>& progress) {
    const auto count = static_cast<std::size_t>(blocks_[0]) * static_cast<std::size_t>(blocks_[1]) *
                       static_cast<std::size_t>(blocks_[2]);
    near_.resize(count);
    for_each_piece(
        count, threads_, [this](std::size_t block) { classify_block(block); }, progress);
    for (std::size_t index = 0; index < field_.brick_slot.size(); ++index) {
      if (field_.brick_slot[index] == kNoBrick) continue;
      field_.brick_slot[index] = static_cast<std::int32_t>(in_band_.size());
      in_band_.push_back(index);
    }
  }

  std::size_t in_band() const { return in_band_.size(); }

  void fill(const std::function<void(double)>& progress) {
    field_.values_float.resize(in_band_.size() * kBrickValues);
    field_.slot_error_m.resize(in_band_.size());
    const auto upto = [&progress](double from, double to) {
      return [&progress, from, to](double fraction) { progress(from + (to - from) * fraction); };
    };
    for_each_piece(
        in_band_.size(), threads_, [this](std::size_t slot) { fill_slot(slot); }, upto(0.0, 0.7));
    for_each_piece(
        in_band_.size(), threads_, [this](std::size_t slot) { finish_slot(slot); }, upto(0.7, 1.0));
    field_.error_bound_m = *std::max_element(field_.slot_error_m.begin(), field_.slot_error_m.end());
  }

private:
  using Place = std::array<std::int32_t, 3>;

  static Place place_of(std::size_t index, const Place& counts) {
    const auto x = static_cast<std::size_t>(counts[0]), y = static_cast<std::size_t>(counts[1]);
    return {static_cast<std::int32_t>(index % x), static_cast<std::int32_t>(index / x % y),
            static_cast<std::int32_t>(index / x / y)};
  }
  static std::size_t index_of(const Place& place, const Place& counts) {
    return static_cast<std::size_t>((place[2] * counts[1] + place[1]) * counts[0] + place[0]);
  }

  Vec3 brick_corner(const Place& brick) const {
    return field_.origin + kBrickCells * field_.voxel_m * Vec3(brick[0], brick[1], brick[2]);
  }
  Vec3 brick_centre(const Place& brick) const {
    return brick_corner(brick) + Vec3::Constant(0.5 * kBrickCells * field_.voxel_m);
  }

  void classify_block(std::size_t block) {
    Place first = place_of(block, blocks_);
    for (std::int32_t& axis : first) axis *= kBlockBricks;
    const double half_edge = 0.5 * kBlockBricks * kBrickCells * field_.voxel_m;
    near_[block].emplace(exact_, solid_, brick_corner(first) + Vec3::Constant(half_edge),
                         kBlockBricks * brick_radius(field_.voxel_m));
    for (std::int32_t k = first[2]; k < std::min(first[2] + kBlockBricks, field_.bricks[2]); ++k) {
      for (std::int32_t j = first[1]; j < std::min(first[1] + kBlockBricks, field_.bricks[1]); ++j)
        for (std::int32_t i = first[0]; i < std::min(first[0] + kBlockBricks, field_.bricks[0]); ++i)
          classify_brick({i, j, k}, *near_[block]);
    }
  }

  void classify_brick(const Place& brick, UnionDistance& near) {
    const double distance = near(brick_centre(brick));
    const std::size_t index = index_of(brick, field_.bricks);
    field_.centre_m[index] = std::nextafter(static_cast<float>(distance), 0.0f);
    if (reaches_band(near, brick_centre(brick), distance))
      field_.brick_slot[index] = 0;  // numbered once all are known
  }

  // A brick between surely and surely not is settled by its octants.
  bool reaches_band(UnionDistance& near, const Vec3& centre, double distance) const {
    const double radius = brick_radius(field_.voxel_m);
    if (std::abs(distance) <= field_.band_m) return true;
    if (std::abs(distance) > field_.band_m + radius) return false;
    const double quarter = 0.25 * kBrickCells * field_.voxel_m;
    for (unsigned octant = 0; octant < 8; ++octant) {
      const auto side = [&](unsigned axis) { return (octant >> axis & 1u) != 0 ? quarter : -quarter; };
      if (std::abs(near(centre + Vec3(side(0), side(1), side(2)))) <= field_.band_m + 0.5 * radius)
        return true;
    }
    return false;
  }

  UnionDistance distance_near(const Place& brick) const {
    const Place block{brick[0] / kBlockBricks, brick[1] / kBlockBricks, brick[2] / kBlockBricks};
    return {*near_[index_of(block, blocks_)], brick_centre(brick), brick_radius(field_.voxel_m)};
  }
  BrickPlace geometry_of(const Place& brick) const {
    return {brick_corner(brick), field_.voxel_m, field_.band_m + std::numbers::sqrt3 * field_.voxel_m};
  }
  std::span<float> values_of(std::size_t slot) {
    return std::span(field_.values_float).subspan(slot * kBrickValues, kBrickValues);
  }

  void fill_slot(std::size_t slot) {
    const Place brick = place_of(in_band_[slot], field_.bricks);
    UnionDistance exact = distance_near(brick);
    fill_own_values(exact, geometry_of(brick), values_of(slot));
  }

  void finish_slot(std::size_t slot) {
    const Place brick = place_of(in_band_[slot], field_.bricks);
    Neighbours neighbours{};
    for (unsigned which = 1; which < neighbours.size(); ++which) {
      Place there = brick;
      bool in_grid = true;
      for (std::size_t axis = 0; axis < 3; ++axis) {
        there[axis] += static_cast<std::int32_t>(which >> axis & 1u);
        in_grid = in_grid && there[axis] < field_.bricks[axis];
      }
      const std::int32_t other = in_grid ? field_.brick_slot[index_of(there, field_.bricks)] : kNoBrick;
      if (other != kNoBrick) neighbours[which] = values_of(static_cast<std::size_t>(other)).data();
    }
    UnionDistance exact = distance_near(brick);
    fill_shared_values(exact, geometry_of(brick), neighbours, values_of(slot));
    field_.slot_error_m[slot] = static_cast<float>(measure_brick(exact, geometry_of(brick), values_of(slot)));
  }

  const Solid& solid_;
  const TriangleDistance& exact_;
  unsigned threads_;
  FieldData& field_;
  Place blocks_{};
  std::vector<std::optional<UnionDistance>> near_;  // (blocks)
  std::vector<std::size_t> in_band_;                // (slots) the brick each slot belongs to
};

}  // namespace

Result<DistanceField> bake_field(const Solid& solid, const FieldDesc& desc, const Progress& progress) {
  const TriangleDistance exact(solid);
  const ThinSpot thinnest = thinnest_wall(solid, exact, desc.threads);
  const Result<Resolution> resolution = choose_resolution(solid, exact, thinnest, desc);
  if (!resolution) return resolution.error();
  FieldData field;
  field.surface_box = solid.bounds();
  field.voxel_m = resolution->voxel_m;
  field.band_m = resolution->band_m;
  field.voxel_reason = resolution->reason;
  field.contact_error_m = resolution->contact_error_m;
  field.thinnest_feature_m = thinnest.thickness_m;
  if (std::optional<Error> error = lay_grid(field)) return *error;

  const auto report = [&progress](double from, double to) {
    return [&progress, from, to](double fraction) {
      if (progress) progress(from + (to - from) * fraction);
    };
  };
  Baker baker(solid, exact, desc, field);
  baker.classify(report(0.0, kClassifyShare));
  const double bytes = static_cast<double>(baker.in_band()) * kBrickValues *
                       (desc.format == FieldFormat::int16 ? sizeof(std::int16_t) : sizeof(float));
  if (bytes > kLargestField) {
    return Error{"A distance field of " + spell_mm(field.voxel_m) + " voxels would need " +
                 spell(bytes * 1e-9) + " GB: use a voxel of " +
                 spell_mm(1.05 * field.voxel_m * std::sqrt(bytes / kLargestField)) +
                 " or more, or a narrower band than " + spell_mm(field.band_m) + "."};
  }
  baker.fill(report(kClassifyShare, 1.0));
  if (desc.format == FieldFormat::int16) quantise(field);
  if (progress) progress(1.0);
  return DistanceField(std::move(field));
}

}  // namespace fulcrum
