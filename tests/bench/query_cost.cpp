#include "tests/bench/query_cost.h"

#include <algorithm>
#include <cmath>

#include "haptics/bake/triangle_distance.h"
#include "haptics/contact/query.h"
#include "tests/bench/cpu_time.h"
#include "tests/bench/gather_floor.h"

namespace fulcrum::bench {
namespace {

constexpr std::size_t kWarmUp = 32;
constexpr std::size_t kFloorPoses = 64;
constexpr double kAllTouchingDepth = 1.0e-3;  // m
constexpr std::size_t kAllTouchingRuns = 40;

// Points without values read elsewhere.
double floor_ns(const DistanceField& field, const Pointshell& shell, const std::vector<Pose>& poses) {
  const FieldData& data = field.data();
  std::int32_t kept = 0;
  std::vector<double> ns;
  for (std::size_t pose = 0; pose < kFloorPoses; ++pose) {
    std::vector<std::int32_t> offsets;
    std::size_t other = 0;
    for (const Vec3& p_T : shell.positions) {
      const Vec3 q = (poses[pose % poses.size()] * p_T - data.origin) / data.voxel_m;
      std::size_t brick = 0, cell = 0;
      for (int axis = 2; axis >= 0; --axis) {
        const auto i = static_cast<std::size_t>(axis);
        const auto at = static_cast<std::size_t>(std::clamp(q[axis], 0.0, data.bricks[i] * 8.0 - 1.0));
        brick = brick * static_cast<std::size_t>(data.bricks[i]) + at / kBrickCells;
        cell = cell * kBrickSide + at % kBrickCells;
      }
      std::size_t slot =
          data.brick_slot[brick] >= 0 ? static_cast<std::size_t>(data.brick_slot[brick]) : other;
      other = slot;
      offsets.push_back(static_cast<std::int32_t>(sizeof(std::int16_t) * (slot * kBrickValues + cell)));
    }
    offsets.resize(offsets.size() / 16 * 16);
    kept |= read_alone(data.values_int16.data(), offsets);
    ns.push_back(1e3 * cpu_us([&] { kept |= read_alone(data.values_int16.data(), offsets); }) /
                 static_cast<double>(offsets.size()));
  }
  volatile std::int32_t used = kept;
  static_cast<void>(used);
  return quantile(ns, 0.5);
}

}  // namespace

void touch(const DistanceField& field) {
  const FieldData& data = field.data();
  double sum = 0;
  for (const auto value : data.values_int16) sum += value;
  for (const float value : data.values_float) sum += static_cast<double>(value);
  for (const auto slot : data.brick_slot) sum += slot;
  volatile double kept = sum;
  static_cast<void>(kept);
}

QueryCost cost_of_queries(const Field& field, const Shell& shell, const std::vector<Pose>& poses,
                          Normals normals) {
  ContactQuery query(shell, field, normals);
  ContactSet set;
  double touched_m2 = 0, all_m2 = 0, contacts = 0;
  for (const double area : shell->areas_m2) all_m2 += area;
  touch(*field);
  for (std::size_t i = 0; i < kWarmUp; ++i) query.run(poses[poses.size() - 1 - i], set);
  std::vector<double> us;
  for (const Pose& X_WT : poses) {
    us.push_back(cpu_us([&] { query.run(X_WT, set); }));
    for (const Contact& contact : set.contacts()) touched_m2 += contact.overlap.area;
    contacts += static_cast<double>(set.contacts().size());
  }
  const auto count = static_cast<double>(poses.size());
  return {quantile(us, 0.5),
          quantile(us, 0.99),
          contacts / count,
          touched_m2 / all_m2 / count,
          floor_ns(*field, *shell, poses),
          shell->size()};
}

QueryCost cost_of_all_touching(const Workload& workload, const Field& field, std::size_t points) {
  Pointshell shell = shell_of(one_pipe(workload), points);
  for (Vec3& p : shell.positions) {
    const Vec3 sunk = p - kAllTouchingDepth * field->sample(p).gradient;
    if (field->distance(sunk) < 0) p = sunk;
  }
  return cost_of_queries(field, std::make_shared<const Pointshell>(std::move(shell)),
                         std::vector<Pose>(kAllTouchingRuns));
}

DepthError depth_error(const Workload& workload, const Field& field, const Shell& shell,
                       const std::vector<Pose>& poses) {
  const TriangleDistance mesh(workload.scene);
  ContactQuery query(shell, field);
  ContactSet set;
  DepthError error{};
  double whole = 0;
  for (const Pose& X_WT : poses) {
    query.run(X_WT, set);
    const double truth = workload.truth.depth(X_WT, kDepthTolerance), found = set.depth_max();
    whole += truth;
    error.percent += std::abs(found - truth);
    const auto contacts = set.contacts();
    const auto deepest = std::max_element(contacts.begin(), contacts.end(),
                                          [](const auto& a, const auto& b) { return a.depth < b.depth; });
    if (deepest == contacts.end()) {
      error.sampling += truth;
      continue;
    }
    const double at_point = -nearest_pipe(workload.pipes, deepest->p_W).distance;
    const double by_mesh = -mesh.signed_distance(deepest->p_W);
    error.sampling += truth - at_point;
    error.mesh += at_point - by_mesh;
    error.field += by_mesh - found;
  }
  for (double* part : {&error.percent, &error.sampling, &error.mesh, &error.field}) *part *= 100 / whole;
  return error;
}

}  // namespace fulcrum::bench
