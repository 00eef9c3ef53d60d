// bench_contact [--json]: what a contact query costs. CPU time of this thread, every pose once, warm; ratios
// to the gather floor of the same run hold on a busy machine and on another one.

#include <time.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iostream>
#include <map>
#include <string>
#include <vector>

#include "haptics/bake/field_bake.h"
#include "haptics/bake/triangle_distance.h"
#include "haptics/contact/query.h"
#include "haptics/math/number_text.h"
#include "tests/bench/contact_workload.h"
#include "tests/bench/gather_floor.h"

namespace fulcrum::bench {
namespace {

constexpr std::size_t kPoses = 2000;
constexpr std::size_t kFloorPoses = 64;
constexpr double kVoxel = 1e-3;  // m: 512 cells and the band on both sides
constexpr double kFiner = 1.5;   // times as many cells; with fewer the scene's walls of 2 mm would be refused
constexpr double kAllTouchingDepth = 1.0e-3;  // m

double cpu_s(clockid_t clock) {
  timespec now{};
  clock_gettime(clock, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class Work>
double cpu_us(const Work& work) {
  const double before = cpu_s(CLOCK_THREAD_CPUTIME_ID);
  work();
  return 1e6 * (cpu_s(CLOCK_THREAD_CPUTIME_ID) - before);
}

double quantile(std::vector<double> of, double share) {
  const auto at = of.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(of.size() - 1));
  std::nth_element(of.begin(), at, of.end());
  return *at;
}

struct Costs {
  double median_us, p99_us, touching_share;
};

Costs cost_of_queries(const std::shared_ptr<const DistanceField>& field,
                      const std::shared_ptr<const Pointshell>& shell, const std::vector<Pose>& poses) {
  ContactQuery query(shell, field);
  ContactSet set;
  double touched_m2 = 0, all_m2 = 0;
  for (const double area : shell->areas_m2) all_m2 += area;
  for (std::size_t i = 0; i < 32; ++i) query.run(poses[poses.size() - 1 - i], set);
  std::vector<double> us;
  for (const Pose& X_WT : poses) {
    us.push_back(cpu_us([&] { query.run(X_WT, set); }));
    for (const Contact& contact : set.contacts()) touched_m2 += contact.overlap.area;
  }
  return {quantile(us, 0.5), quantile(us, 0.99), touched_m2 / all_m2 / static_cast<double>(poses.size())};
}

// ns a point of four gathers at the addresses of the poses' points; points without values read elsewhere.
double floor_ns(const DistanceField& field, const Pointshell& shell, const std::vector<Pose>& poses) {
  const FieldData& data = field.data();
  std::int32_t kept = 0;
  std::vector<double> ns;
  for (std::size_t pose = 0; pose < kFloorPoses; ++pose) {
    std::vector<std::int32_t> offsets;
    std::size_t other = 0;
    for (const Vec3& p_T : shell.positions) {
      const Vec3 q = (poses[pose] * p_T - data.origin) / data.voxel_m;
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

// The depths of the touching points against the exact distance, in per cent of the deepest.
double depth_error_percent(const std::shared_ptr<const DistanceField>& field,
                           const std::shared_ptr<const Pointshell>& shell, const TriangleDistance& exact,
                           const std::vector<Pose>& poses) {
  ContactQuery query(shell, field);
  ContactSet set;
  double error = 0, whole = 0;
  for (std::size_t i = 0; i < poses.size(); i += 20) {
    query.run(poses[i], set);
    double found = 0, truth = 0;
    for (const Contact& contact : set.contacts()) {
      found += contact.depth;
      truth += std::max(0.0, -exact.signed_distance(contact.p_W));
    }
    error += std::abs(found - truth);
    whole += truth;
  }
  return 100 * error / whole;
}

// A tool whose every point lies inside the scene: points of one of its pipes, moved inwards by
// kAllTouchingDepth.
std::shared_ptr<const Pointshell> sunk_shell(const DistanceField& field, std::size_t n) {
  Pointshell shell = shell_of(one_pipe(), n);
  for (std::size_t i = 0; i < shell.size(); ++i) {
    const Vec3 sunk = shell.positions[i] - kAllTouchingDepth * field.sample(shell.positions[i]).gradient;
    if (field.distance(sunk) < 0) shell.positions[i] = sunk;
  }
  return std::make_shared<Pointshell>(std::move(shell));
}

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);) {
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  }
  return "unknown";
}

void print(const std::vector<std::pair<std::string, std::string>>& rows, bool json) {
  std::string separator = json ? "{\n" : "";
  for (const auto& [key, value] : rows) {
    std::cout << separator << (json ? "  \"" + key + "\": " + value : key + "  " + value);
    separator = json ? ",\n" : "\n";
  }
  std::cout << (json ? "\n}\n" : "\n");
}

int run(bool json) {
  const Solid scene = piping(), tool = spanner();
  const auto baked = [&](double voxel) {
    Result<DistanceField> field = bake_field(scene, {.voxel_m = voxel, .band_m = 2 * voxel});
    if (!field) throw std::runtime_error(field.error().sentence);
    return std::make_shared<const DistanceField>(std::move(*field));
  };
  const double before = cpu_s(CLOCK_PROCESS_CPUTIME_ID);
  const auto field = baked(kVoxel);
  const double bake_s = cpu_s(CLOCK_PROCESS_CPUTIME_ID) - before;
  const auto fine = baked(kVoxel / kFiner);

  const auto poses = touching_poses(*field, shell_of(tool, 1000), kPoses, 11);
  std::map<std::size_t, Costs> costs;
  std::map<std::size_t, double> floor;
  Costs finer{};
  double depth_error = 0;
  for (const std::size_t points : {1000u, 10000u, 100000u, 1000000u}) {
    const auto shell = std::make_shared<const Pointshell>(shell_of(tool, points));
    costs[points] = cost_of_queries(field, shell, poses);
    floor[points] = floor_ns(*field, *shell, poses);
    if (points == 10000) {
      finer = cost_of_queries(fine, shell, poses);
      depth_error = depth_error_percent(field, shell, TriangleDistance(scene), poses);
    }
  }
  const auto sunk = sunk_shell(*field, 1000000);
  const Costs all = cost_of_queries(field, sunk, std::vector<Pose>(40));
  const double sunk_floor = floor_ns(*field, *sunk, std::vector<Pose>(kFloorPoses));

  const auto text = [](double value) { return number_text(value, 4); };
  print({{"floor_ns_per_point", text(floor[10000])},
         {"floor_1m_ns_per_point", text(floor[1000000])},
         {"query_1k_us", text(costs[1000].median_us)},
         {"query_10k_us", text(costs[10000].median_us)},
         {"query_10k_p99_us", text(costs[10000].p99_us)},
         {"query_10k_over_floor", text(costs[10000].median_us / (10 * floor[10000]))},
         {"query_100k_us", text(costs[100000].median_us)},
         {"query_1m_us", text(costs[1000000].median_us)},
         {"query_1m_p99_us", text(costs[1000000].p99_us)},
         {"query_1m_p99_over_floor", text(costs[1000000].p99_us / (1000 * floor[1000000]))},
         {"all_touching_share", text(all.touching_share)},
         {"all_touching_ns_per_point", text(1e-3 * all.median_us)},
         {"all_touching_floor_ns_per_point", text(sunk_floor)},
         {"all_touching_over_floor", text(1e-3 * all.median_us / sunk_floor)},
         {"slope_points", text(std::log10(costs[1000000].median_us / costs[1000].median_us) / 3)},
         {"slope_resolution", text(std::log(finer.median_us / costs[10000].median_us) / std::log(kFiner))},
         {"touching_share", text(costs[10000].touching_share)},
         {"field_512_MB", text(1e-6 * static_cast<double>(field->bytes()))},
         {"field_512_voxel_mm", text(1e3 * field->voxel_m())},
         {"field_512_error_mm", text(1e3 * field->error_bound_m())},
         {"bake_512_cpu_s", text(bake_s)},
         {"depth_error_percent", text(depth_error)},
         {"scene_triangles", std::to_string(scene.mesh.triangles.size())},
         {"tool_triangles", std::to_string(tool.mesh.triangles.size())},
         {"machine", "\"" + processor() + "\""},
         {"simd", std::string("\"") + simd_target() + "\""}},
        json);
  return 0;
}

}  // namespace
}  // namespace fulcrum::bench

int main(int argc, char** argv) {
  const bool json = argc == 2 && std::string_view(argv[1]) == "--json";
  if (argc > 1 && !json) {
    std::cerr << "bench_contact [--json]\n";
    return 2;
  }
  try {
    return fulcrum::bench::run(json);
  } catch (const std::exception& fault) {
    std::cerr << fault.what() << '\n';
    return 1;
  }
}
