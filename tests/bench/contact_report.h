#pragma once
// What `tools/bench contact` found out, as tables for people and as JSON for programs.

#include <iosfwd>
#include <string>
#include <vector>

#include "tests/bench/peer_cost.h"
#include "tests/bench/piping_tick.h"
#include "tests/bench/query_cost.h"

namespace fulcrum::bench {

struct Report {
  std::string machine, simd;
  std::size_t scene_triangles = 0, tool_triangles = 0, poses = 0, compared_poses = 0;
  QueryCost at_1k{}, at_10k{}, at_100k{}, at_1m{};
  QueryCost at_10k_finer{};  // in a field of finer_by times as many cells along an edge
  double finer_by = 1;
  QueryCost compared{};  // as at_10k, over the poses and with the shell of the comparison
  QueryCost all_touching{};
  DepthError depth{};
  QueryCost across_cells{};  // as compared, with the normals that springs want
  QueryCost even{};          // as compared, with a shell that takes no account of roundings
  DepthError even_depth{};
  QueryCost fine{};  // as compared, with a shell of 0.4 mm
  DepthError fine_depth{};
  double voxel_m = 0, field_MB = 0, field_error_m = 0, bake_cpu_s = 0;
  TickCost tick{};
  std::vector<PeerResult> peers;
};

void write_tables(const Report& report, std::ostream& out);
void write_json(const Report& report, std::ostream& out);

}  // namespace fulcrum::bench
