#include "tests/bench/contact_report.h"

#include <algorithm>
#include <cmath>
#include <ostream>
#include <utility>

#include "haptics/math/number_text.h"

namespace fulcrum::bench {
namespace {

using Row = std::vector<std::string>;

// 123 456
std::string count_text(std::size_t value) {
  std::string digits = std::to_string(value);
  for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, 1, ' ');
  return digits;
}

std::string text(double value) {
  return value < 1000 ? number_text(value, 3) : count_text(static_cast<std::size_t>(std::lround(value)));
}

// The first column to the left, the others to the right.
void write_table(const std::vector<Row>& rows, std::ostream& out) {
  std::vector<std::size_t> width(rows.front().size());
  for (const Row& row : rows)
    for (std::size_t i = 0; i < row.size(); ++i) width[i] = std::max(width[i], row[i].size());
  for (const Row& row : rows) {
    out << "  ";
    for (std::size_t i = 0; i < row.size(); ++i) {
      const std::string space(width[i] - row[i].size(), ' ');
      out << (i == 0 ? row[i] + space : "  " + space + row[i]);
    }
    out << '\n';
  }
}

double slope_of_points(const Report& r) {
  return std::log10(r.at_1m.median_us / r.at_1k.median_us) / 3;
}

double slope_of_cells(const Report& r) {
  return std::log(r.at_10k_finer.median_us / r.at_10k.median_us) / std::log(r.finer_by);
}

Row query_row(const QueryCost& cost, const std::string& note = "") {
  return {count_text(cost.points) + note,
          text(cost.median_us),
          text(cost.p99_us),
          text(cost.contacts),
          text(cost.floor_ns),
          text(cost.over_floor(cost.median_us)),
          text(cost.over_floor(cost.p99_us))};
}

void write_queries(const Report& r, std::ostream& out) {
  out << "Our query: processor time over " << count_text(r.poses)
      << " poses. F is the floor, what four gathers a point cost "
      << "at the same\naddresses without arithmetic.\n\n";
  write_table({{"points", "median us", "p99 us", "contacts", "F, ns a point", "median / F", "p99 / F"},
               query_row(r.at_1k),
               query_row(r.at_10k),
               query_row(r.at_100k),
               query_row(r.at_1m),
               query_row(r.all_touching, ", all touching")},
              out);
}

Row our_row(const Report& r, const QueryCost& cost, const DepthError& depth, const std::string& note) {
  return {"Fulcrum, " + count_text(cost.points) + " points" + note,
          text(cost.median_us),
          text(cost.p99_us),
          text(cost.median_us / r.compared.median_us),
          text(cost.contacts),
          text(depth.percent)};
}

void write_peers(const Report& r, std::ostream& out) {
  out << "\nThe same question to other libraries, over " << r.compared_poses
      << " of the poses. The depth is that of the deepest contact, its error\n"
         "against the true depth of the spanner's surface in swept circles.\n\n";
  std::vector<Row> rows{{"", "median us", "p99 us", "times ours", "contacts", "depth error %"},
                        our_row(r, r.compared, r.depth, "")};
  for (const PeerResult& peer : r.peers) {
    if (!peer.cost) continue;
    rows.push_back({peer.name, text(peer.cost->median_us), text(peer.cost->p99_us),
                    text(peer.cost->median_us / r.compared.median_us), text(peer.cost->contacts),
                    text(peer.cost->depth_error_percent)});
  }
  rows.push_back(our_row(r, r.across_cells, r.depth, ", second-order normals"));
  rows.push_back(our_row(r, r.even, r.even_depth, ", spread evenly"));
  rows.push_back(our_row(r, r.fine, r.fine_depth, ""));
  write_table(rows, out);
  out << "\nBy how much ours falls short, in % of the depth, and why:\n\n";
  const auto share_row = [](const QueryCost& cost, const DepthError& depth) -> Row {
    return {count_text(cost.points) + " points", text(depth.sampling), text(depth.mesh), text(depth.field)};
  };
  write_table({{"", "no point at the deepest place", "pipes are triangles", "field"},
               share_row(r.compared, r.depth),
               share_row(r.even, r.even_depth),
               share_row(r.fine, r.fine_depth)},
              out);
}

void write_rest(const Report& r, std::ostream& out) {
  const TickCost& t = r.tick;
  out << "\nThe rest:\n\n";
  write_table({{"a tick of the piping scenario, constraint, median", text(t.median_us) + " us"},
               {"  p99", text(t.p99_us) + " us"},
               {"  ticks in contact", count_text(t.ticks)},
               {"  of these, with a motion cut short", count_text(t.limited_ticks)},
               {"  and their median", text(t.limited_median_us) + " us"},
               {"  contact regions, mean", text(t.regions)},
               {"  points near enough to be constraints, mean", text(t.near_points)},
               {"  of", count_text(t.shell_points)},
               {"field of the pipes, cells of " + text(1e3 * r.voxel_m) + " mm", text(r.field_MB) + " MB"},
               {"  bake, processor time", text(r.bake_cpu_s) + " s"},
               {"  error, at most", text(1e3 * r.field_error_m) + " mm"},
               {"  exponent of query time in points, 1 000 to 1 000 000", text(slope_of_points(r))},
               {"  in cells along an edge", text(slope_of_cells(r))},
               {"field of the whole plant", text(t.field_MB) + " MB"},
               {"  bake, processor time, with the spanner's points", text(t.bake_cpu_s) + " s"}},
              out);
}

}  // namespace

void write_tables(const Report& r, std::ostream& out) {
  out << "Contact on " << r.machine << ", " << r.simd << "\n"
      << "A ring spanner of " << count_text(r.tool_triangles) << " triangles in pipes of "
      << count_text(r.scene_triangles) << ", " << text(1e3 * kPenetration) << " mm deep\n\n";
  write_queries(r, out);
  write_peers(r, out);
  write_rest(r, out);
}

void write_json(const Report& r, std::ostream& out) {
  std::vector<std::pair<std::string, std::string>> rows;
  const auto add = [&](const std::string& key, double value) {
    rows.emplace_back(key, number_text(value, 4));
  };
  add("floor_ns_per_point", r.at_10k.floor_ns);
  add("floor_1m_ns_per_point", r.at_1m.floor_ns);
  add("query_1k_us", r.at_1k.median_us);
  add("query_10k_us", r.at_10k.median_us);
  add("query_10k_p99_us", r.at_10k.p99_us);
  add("query_10k_over_floor", r.at_10k.over_floor(r.at_10k.median_us));
  add("query_100k_us", r.at_100k.median_us);
  add("query_1m_us", r.at_1m.median_us);
  add("query_1m_p99_us", r.at_1m.p99_us);
  add("query_1m_p99_over_floor", r.at_1m.over_floor(r.at_1m.p99_us));
  add("all_touching_share", r.all_touching.touching_share);
  add("all_touching_over_floor", r.all_touching.over_floor(r.all_touching.median_us));
  add("slope_points", slope_of_points(r));
  add("slope_resolution", slope_of_cells(r));
  add("touching_share", r.at_10k.touching_share);
  add("field_512_MB", r.field_MB);
  add("field_512_voxel_mm", 1e3 * r.voxel_m);
  add("field_512_error_mm", 1e3 * r.field_error_m);
  add("bake_512_cpu_s", r.bake_cpu_s);
  add("plant_field_MB", r.tick.field_MB);
  add("plant_bake_cpu_s", r.tick.bake_cpu_s);
  add("tick_piping_us", r.tick.median_us);
  add("tick_piping_p99_us", r.tick.p99_us);
  add("tick_piping_limited_us", r.tick.limited_median_us);
  add("tick_piping_regions", r.tick.regions);
  add("tick_piping_near_points", r.tick.near_points);
  add("depth_error_percent", r.depth.percent);
  add("depth_error_sampling_percent", r.depth.sampling);
  add("depth_error_mesh_percent", r.depth.mesh);
  add("depth_error_field_percent", r.depth.field);
  add("across_cells_us", r.across_cells.median_us);
  add("depth_error_even_percent", r.even_depth.percent);
  add("even_us", r.even.median_us);
  add("depth_error_fine_percent", r.fine_depth.percent);
  add("fine_us", r.fine.median_us);
  add("compared_us", r.compared.median_us);
  for (const PeerResult& peer : r.peers) {
    const auto add_peer = [&](const std::string& key, double value) {
      rows.emplace_back(key, peer.cost ? number_text(value, 4) : "null");
    };
    const PeerCost cost = peer.cost.value_or(PeerCost{});
    add_peer(peer.key + "_us", cost.median_us);
    add_peer(peer.key + "_depth_error_percent", cost.depth_error_percent);
    add_peer("ratio_" + peer.key, cost.median_us / r.compared.median_us);
    if (peer.key == "fcl") add_peer("tick_piping_p99_over_fcl", r.tick.p99_us / cost.median_us);
  }
  rows.emplace_back("scene_triangles", std::to_string(r.scene_triangles));
  rows.emplace_back("tool_triangles", std::to_string(r.tool_triangles));
  rows.emplace_back("machine", '"' + r.machine + '"');
  rows.emplace_back("simd", '"' + r.simd + '"');

  std::string separator = "{\n";
  for (const auto& [key, value] : rows) {
    out << separator << "  \"" << key << "\": " << value;
    separator = ",\n";
  }
  out << "\n}\n";
}

}  // namespace fulcrum::bench
