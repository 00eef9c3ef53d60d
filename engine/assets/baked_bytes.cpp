#include "engine/assets/baked_bytes.h"

#include <algorithm>
#include <cmath>

#include "engine/assets/byte_stream.h"

namespace fulcrum {
namespace {

using Xyz = std::array<double, 3>;

Xyz xyz(const Vec3& v) {
  return {v.x(), v.y(), v.z()};
}
Vec3 vec3(const Xyz& v) {
  return {v[0], v[1], v[2]};
}

std::vector<Xyz> all_xyz(const std::vector<Vec3>& vectors) {
  std::vector<Xyz> result;
  result.reserve(vectors.size());
  for (const Vec3& v : vectors) result.push_back(xyz(v));
  return result;
}

std::vector<Vec3> all_vec3(const std::vector<Xyz>& vectors) {
  std::vector<Vec3> result;
  result.reserve(vectors.size());
  for (const Xyz& v : vectors) result.push_back(vec3(v));
  return result;
}

bool is_of_one_piece(const FieldData& field) {
  double bricks = 1.0;
  for (const std::int32_t along : field.bricks) {
    if (along <= 0) return false;
    bricks *= along;
  }
  const bool is_int16 = field.format == FieldFormat::int16;
  const std::size_t slots = field.slot_error_m.size();
  return bricks == static_cast<double>(field.brick_slot.size()) &&
         field.centre_m.size() == field.brick_slot.size() && slots > 0 &&
         field.values_int16.size() == (is_int16 ? slots * kBrickValues : 0) &&
         field.values_float.size() == (is_int16 ? 0 : slots * kBrickValues) &&
         std::isfinite(field.quantum_m) && field.voxel_m > 0.0 && std::isfinite(field.voxel_m) &&
         field.origin.allFinite() && field.surface_box.min().allFinite() &&
         field.surface_box.max().allFinite() &&
         std::all_of(field.brick_slot.begin(), field.brick_slot.end(), [slots](std::int32_t slot) {
           return slot == kNoBrick || (slot >= 0 && static_cast<std::size_t>(slot) < slots);
         });
}

}  // namespace

std::vector<std::byte> to_bytes(const DistanceField& field) {
  const FieldData& data = field.data();
  ByteWriter out;
  for (const Vec3& v : {data.origin, data.surface_box.min(), data.surface_box.max()}) out.value(xyz(v));
  for (const double x :
       {data.voxel_m, data.band_m, data.error_bound_m, data.thinnest_feature_m, data.contact_error_m})
    out.value(x);
  out.value(data.voxel_reason);
  out.value(data.bricks);
  out.vector(data.brick_slot);
  out.vector(data.centre_m);
  out.value(data.format);
  out.value(data.quantum_m);
  out.vector(data.values_float);
  out.vector(data.values_int16);
  out.vector(data.slot_error_m);
  return out.bytes();
}

std::optional<DistanceField> field_from_bytes(std::span<const std::byte> bytes) {
  ByteReader in(bytes);
  FieldData data;
  data.origin = vec3(in.value<Xyz>());
  const Vec3 low = vec3(in.value<Xyz>()), high = vec3(in.value<Xyz>());
  data.surface_box = Box3(low, high);
  for (double* x :
       {&data.voxel_m, &data.band_m, &data.error_bound_m, &data.thinnest_feature_m, &data.contact_error_m})
    *x = in.value<double>();
  data.voxel_reason = in.value<VoxelReason>();
  data.bricks = in.value<std::array<std::int32_t, 3>>();
  data.brick_slot = in.vector<std::int32_t>();
  data.centre_m = in.vector<float>();
  data.format = in.value<FieldFormat>();
  data.quantum_m = in.value<double>();
  data.values_float = in.vector<float, HugePages<float>>();
  data.values_int16 = in.vector<std::int16_t, HugePages<std::int16_t>>();
  data.slot_error_m = in.vector<float>();
  if (!in.finished_well() || !is_of_one_piece(data)) return std::nullopt;
  return DistanceField(std::move(data));
}

std::vector<std::byte> to_bytes(const Pointshell& shell) {
  ByteWriter out;
  out.value(shell.covering_radius_m);
  out.value(shell.max_radius_m);
  out.vector(all_xyz(shell.positions));
  out.vector(all_xyz(shell.normals));
  out.vector(shell.areas_m2);
  return out.bytes();
}

std::optional<Pointshell> pointshell_from_bytes(std::span<const std::byte> bytes) {
  ByteReader in(bytes);
  Pointshell shell;
  shell.covering_radius_m = in.value<double>();
  shell.max_radius_m = in.value<double>();
  shell.positions = all_vec3(in.vector<Xyz>());
  shell.normals = all_vec3(in.vector<Xyz>());
  shell.areas_m2 = in.vector<double>();
  const std::size_t n = shell.size();
  const bool good = in.finished_well() && n > 0 && shell.normals.size() == n && shell.areas_m2.size() == n;
  return good ? std::optional(std::move(shell)) : std::nullopt;
}

}  // namespace fulcrum
