#include "haptics/bake/resolution.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "haptics/bake/parallel.h"
#include "haptics/bake/sentence.h"
#include "haptics/bake/surface_samples.h"
#include "haptics/math/functions.h"

namespace fulcrum {
namespace {

constexpr double kVoxelsPerWall =
    3.0;                         // ground truths: with fewer the inside is soft, with two it may be gone
constexpr double kRoom = 0.997;  // for the rounding of a wall of exactly three
constexpr double kVoxelsPerError = 20.0;
constexpr double kSamples = 2000.0;
constexpr double kCovered = 1e-9;     // m, of distances, and more
constexpr double kKept = 0.95;        // of the surface
constexpr double kMaxChosen = 512e6;  // bytes
// Bricks are 8 voxels wide, and a band of two voxels on either side meets some 13 voxels' worth of them: 9^3
// values for 8^3 cells over 13 voxels.
constexpr double kValuesPerFace = 19.0;  // of a voxel

bool is_length(double x) {
  return x > 0.0 && std::isfinite(x);
}

std::optional<Error> check_desc(const FieldDesc& desc) {
  if (desc.voxel_m && !is_length(*desc.voxel_m)) {
    return Error{"A distance field's voxel must be a positive length, not " + spell(*desc.voxel_m) +
                 " m: 0.001 suits hand tools."};
  }
  if (!is_length(desc.error_m)) {
    return Error{"A distance field's wanted error must be a positive length, not " + spell(desc.error_m) +
                 " m: 0.00005 suits hand tools."};
  }
  if (desc.band_m && !(is_length(*desc.band_m) && *desc.band_m >= 2.0 * desc.voxel_m.value_or(0.0))) {
    return Error{"A distance field's band must be at least two voxels (" +
                 spell_mm(2.0 * desc.voxel_m.value_or(0.0)) + "), not " + spell_mm(*desc.band_m) +
                 ": two voxels serve most tools."};
  }
  return std::nullopt;
}

// Down to two digits, so that it can be said and typed.
double rounded_down(double length) {
  const double per_digit = math::pow(10.0, 1.0 - std::floor(math::log10(length)));
  return std::floor(length * per_digit * (1.0 + 1e-12)) / per_digit;
}

double value_between_corners(const TriangleDistance& exact, const Vec3& p, double h) {
  const Vec3 cell = (p / h).array().floor();
  const Vec3 t = p / h - cell;
  double value = 0.0;
  for (unsigned corner = 0; corner < 8; ++corner) {
    const Vec3 upper(corner & 1u, corner >> 1 & 1u, corner >> 2 & 1u);
    const Vec3 share = upper.cwiseProduct(t) + (Vec3::Ones() - upper).cwiseProduct(Vec3::Ones() - t);
    value += share.prod() * exact.signed_distance(h * (cell + upper));
  }
  return value;
}

}  // namespace

double contact_error(const Solid& solid, const TriangleDistance& exact, double voxel_m, unsigned threads) {
  const SurfaceSamples all = sample_surface(solid.mesh, surface_area(solid.mesh) / kSamples, 1);
  const std::size_t count = std::min(all.points.size(), static_cast<std::size_t>(kSamples));
  struct Measured {
    double error, area;
  };
  std::vector<Measured> measured(count);
  for_each_piece(
      count, threads,
      [&](std::size_t i) {
        const Vec3& p = all.points[i].position;
        const bool covered = exact.signed_distance(p) < -kCovered;  // by another component
        measured[i] = {std::abs(value_between_corners(exact, p, voxel_m)), covered ? 0.0 : all.areas_m2[i]};
      },
      {});
  std::sort(measured.begin(), measured.end(),
            [](const Measured& l, const Measured& r) { return l.error < r.error; });
  double whole = 0.0, upto = 0.0;
  for (const Measured& one : measured) whole += one.area;
  for (const Measured& one : measured) {
    upto += one.area;
    if (upto >= kKept * whole) return one.error;
  }
  return measured.back().error;
}

namespace {

// The coarsest voxel with which all that is asked holds, or the finest that memory allows.
class Choice {
public:
  Choice(const Solid& solid, const TriangleDistance& exact, const ThinSpot& thinnest, const FieldDesc& desc)
      : solid_(solid), exact_(exact), thinnest_(thinnest), desc_(desc) {
    const double bytes_per_value = desc.format == FieldFormat::int16 ? 2.0 : 4.0;
    affordable_ = std::sqrt(bytes_per_value * kValuesPerFace * surface_area(solid.mesh) / kMaxChosen);
  }

  Result<Resolution> make() {
    const double thin = thinnest_.thickness_m / kVoxelsPerWall;
    if (affordable_ > thin) {
      return Error{"A wall near " + spell(thinnest_.place) + " is " + spell_mm(thinnest_.thickness_m) +
                   " thick, and three voxels across it would make a field of about " +
                   spell(kMaxChosen * 1e-9 * math::square(affordable_ / thin)) +
                   " GB: make the wall thicker, divide the scene, or give a voxel of " +
                   spell_mm(rounded_down(thin)) + " or less yourself."};
    }
    if (desc_.band_m && 0.5 * *desc_.band_m < affordable_) {
      return Error{"A band of " + spell_mm(*desc_.band_m) +
                   " needs a voxel of half of it, and that would make too large a field: give a band of " +
                   spell_mm(2.1 * affordable_) + " or more."};
    }
    limit(kVoxelsPerError * desc_.error_m, VoxelReason::error);
    limit(thin, VoxelReason::thinnest_wall);
    if (desc_.band_m) limit(0.5 * *desc_.band_m, VoxelReason::band);
    for (measure(); result_.contact_error_m > desc_.error_m && result_.voxel_m > affordable_; measure()) {
      const double shrink = 0.97 * std::sqrt(desc_.error_m / result_.contact_error_m);
      limit(std::max(0.5, shrink) * result_.voxel_m, VoxelReason::error);
    }
    if (result_.voxel_m < affordable_) {
      result_.voxel_m = rounded_down(affordable_);
      result_.reason = VoxelReason::memory;
      measure();
    }
    return result_;
  }

private:
  void limit(double voxel, VoxelReason reason) {
    if (result_.voxel_m > 0.0 && voxel >= result_.voxel_m) return;
    result_.voxel_m = rounded_down(voxel);
    result_.reason = reason;
  }
  void measure() { result_.contact_error_m = contact_error(solid_, exact_, result_.voxel_m, desc_.threads); }

  const Solid& solid_;
  const TriangleDistance& exact_;
  const ThinSpot& thinnest_;
  const FieldDesc& desc_;
  double affordable_ = 0.0;  // m, the voxel that fills the memory
  Resolution result_;
};

}  // namespace

Result<Resolution> choose_resolution(const Solid& solid, const TriangleDistance& exact,
                                     const ThinSpot& thinnest, const FieldDesc& desc) {
  if (std::optional<Error> error = check_desc(desc)) return *error;
  Result<Resolution> result = Resolution{};
  if (!desc.voxel_m) {
    result = Choice(solid, exact, thinnest, desc).make();
    if (!result) return result;
  } else {
    const double thin = thinnest.thickness_m / kVoxelsPerWall;
    if (kRoom * *desc.voxel_m > thin) {
      return Error{"A wall near " + spell(thinnest.place) + " is " + spell_mm(thinnest.thickness_m) +
                   " thick, and needs three voxels across: use a voxel of " + spell_mm(rounded_down(thin)) +
                   " or less instead of " + spell_mm(*desc.voxel_m) + ", or make the wall thicker."};
    }
    result->voxel_m = *desc.voxel_m;
    result->contact_error_m = contact_error(solid, exact, *desc.voxel_m, desc.threads);
  }
  result->band_m = desc.band_m.value_or(2.0 * result->voxel_m);
  return result;
}

}  // namespace fulcrum
