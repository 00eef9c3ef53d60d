// bench_contact [--json] [--smoke]: what a contact query costs. CPU time of this thread, every pose once,
// warm; ratios to the gather floor and to other libraries, all in the same run, hold on a busy machine and on
// another one.
// --smoke: one pose in coarse fields of the pipes, which shows that the benchmark works and measures nothing.

#include <sys/mman.h>

#include <fstream>
#include <iostream>
#include <span>
#include <stdexcept>
#include <string_view>

#include "haptics/bake/field_bake.h"
#include "haptics/bake/pointshell_bake.h"
#include "haptics/contact/shell_walk.h"
#include "tests/bench/contact_report.h"
#include "tests/bench/cpu_time.h"

namespace fulcrum::bench {
namespace {

struct Effort {
  std::size_t poses, compared_every;
  double coarser;  // times as large are voxels
};
constexpr Effort kWhole{.poses = 2000, .compared_every = 4, .coarser = 1};
constexpr Effort kSmoke{.poses = 1, .compared_every = 1, .coarser = 4};

constexpr unsigned kSeed = 11;
constexpr double kVoxel = 1e-3;  // m: 512 cells and the band on both sides
constexpr double kFiner = 1.5;   // times as many cells
// Shells of about 10 000 points: one that follows the spanner's roundings, and one spread evenly.
constexpr PointshellDesc kShell{.spacing_m = 1.2e-3, .deviation = 15e-6};
constexpr PointshellDesc kEven{.spacing_m = 1.01e-3};
constexpr PointshellDesc kFine{.spacing_m = 0.4e-3, .deviation = 15e-6};

Field baked_field(const Solid& scene, double voxel) {
  Result<DistanceField> field = bake_field(scene, {.voxel_m = voxel, .band_m = 2 * voxel});
  if (!field) throw std::runtime_error(field.error().sentence);
  return std::make_shared<const DistanceField>(std::move(*field));
}

Shell baked_shell(const Solid& tool, const PointshellDesc& desc) {
  Result<Pointshell> shell = bake_pointshell(tool, desc);
  if (!shell) throw std::runtime_error(shell.error().sentence);
  return std::make_shared<const Pointshell>(std::move(*shell));
}

Shell random_shell(const Solid& tool, std::size_t points) {
  return std::make_shared<const Pointshell>(shell_of(tool, points));
}

std::string processor() {
  std::ifstream info("/proc/cpuinfo");
  for (std::string line; std::getline(info, line);)
    if (line.starts_with("model name")) return line.substr(line.find(':') + 2);
  return "unknown";
}

Report measure(const Effort& effort) {
  const double voxel = kVoxel * effort.coarser;
  const Workload workload = make_workload();
  const std::vector<Pose> poses = touching_poses(workload, effort.poses, kSeed);
  std::vector<Pose> compared;
  for (std::size_t i = 0; i < poses.size(); i += effort.compared_every) compared.push_back(poses[i]);

  Report report;
  report.machine = processor();
  report.simd = simd_target();
  report.scene_triangles = workload.scene.mesh.triangles.size();
  report.tool_triangles = workload.tool.mesh.triangles.size();
  report.poses = poses.size();
  report.compared_poses = compared.size();

  const double before = cpu_s(CLOCK_PROCESS_CPUTIME_ID);
  const Field field = baked_field(workload.scene, voxel);
  report.bake_cpu_s = cpu_s(CLOCK_PROCESS_CPUTIME_ID) - before;
  report.voxel_m = voxel;
  report.field_MB = 1e-6 * static_cast<double>(field->bytes());
  report.field_error_m = field->error_bound_m();

  const auto cost = [&](std::size_t points) {
    return cost_of_queries(field, random_shell(workload.tool, points), poses);
  };
  const Shell shell = baked_shell(workload.tool, kShell);
  report.at_1k = cost(1000);
  report.at_10k = cost_of_queries(field, shell, poses);
  report.at_100k = cost(100000);
  report.at_1m = cost(1000000);
  report.finer_by = kFiner;
  report.at_10k_finer = cost_of_queries(baked_field(workload.scene, voxel / kFiner), shell, poses);
  report.all_touching = cost_of_all_touching(workload, field, 1000000);

  report.compared = cost_of_queries(field, shell, compared);
  report.across_cells = cost_of_queries(field, shell, compared, Normals::across_cells);
  report.peers = cost_of_peers(workload, compared);
  report.depth = depth_error(workload, field, shell, compared);
  const Shell even = baked_shell(workload.tool, kEven);
  report.even = cost_of_queries(field, even, compared);
  report.even_depth = depth_error(workload, field, even, compared);
  const Shell fine = baked_shell(workload.tool, kFine);
  report.fine = cost_of_queries(field, fine, compared);
  report.fine_depth = depth_error(workload, field, fine, compared);
  report.tick = cost_of_piping_ticks();
  return report;
}

}  // namespace
}  // namespace fulcrum::bench

int main(int argc, char** argv) {
  bool json = false, smoke = false;
  for (const std::string_view argument : std::span(argv, static_cast<std::size_t>(argc)).subspan(1)) {
    if (argument != "--json" && argument != "--smoke") {
      std::cerr << "bench_contact [--json] [--smoke]\n";
      return 2;
    }
    (argument == "--json" ? json : smoke) = true;
  }
  // As a haptic loop would: a page that the system takes back in between costs a hundred microseconds.
  if (mlockall(MCL_CURRENT | MCL_FUTURE) != 0)
    std::cerr << "Memory could not be locked: times at p99 may hold page faults (see ulimit -l).\n";
  try {
    const fulcrum::bench::Report report =
        fulcrum::bench::measure(smoke ? fulcrum::bench::kSmoke : fulcrum::bench::kWhole);
    for (const auto& peer : report.peers) {
      if (!peer.cost)
        std::cerr << peer.name << " is not compared with: " << peer.package
                  << " was not there when this program was configured.\n";
    }
    (json ? fulcrum::bench::write_json : fulcrum::bench::write_tables)(report, std::cout);
    return 0;
  } catch (const std::exception& fault) {
    std::cerr << fault.what() << '\n';
    return 1;
  }
}
