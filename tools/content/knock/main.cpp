// make_knock: writes the models of the knock scene, prints the knocks in it, and checks both.

#include <algorithm>
#include <array>
#include <cstdio>
#include <span>

#include "tools/content/knock/bar.h"
#include "tools/content/knock/bench.h"
#include "tools/content/knock/pegs.h"
#include "tools/content/knock/route.h"
#include "tools/content/mesh/maker.h"
#include "tools/content/mesh/solid_check.h"
#include "tools/content/mesh/way_check.h"

namespace fulcrum::content {
namespace {

constexpr double press_depth = 3.0 * mm;
constexpr double stride = 1.0 * mm;
constexpr double widest_gap = 0.15 * mm;      // to the pegs that a knock meets
constexpr double least_clearance = 2.0 * mm;  // to all else, then and on the way

std::array<Model, 4> make_scene() {
  return {make_boards(), make_steel_pegs(), make_wooden_pegs(), make_rubber_pegs()};
}

double distance(const std::vector<Eigen::Vector3d>& points_W, const Part& part) {
  TriangleTree tree;
  tree.add(part.solid);
  tree.build();
  double least = 5.0 * mm;
  for (const Eigen::Vector3d& p_W : points_W) least = tree.distance(p_W, least);
  return least;
}

// A knock meets its pegs and nothing else.
bool check_knock(const Knock& knock, std::span<const Model> scene,
                 const std::vector<Eigen::Vector3d>& bar_T) {
  std::vector<Eigen::Vector3d> bar_W;
  for (const Eigen::Vector3d& p_T : bar_T) bar_W.push_back(knock.X_WT * p_T);
  double gap = 0.0;
  double clearance = 5.0 * mm;
  for (const Model& model : scene) {
    for (const Part& part : model.parts) {
      const double d = distance(bar_W, part);
      if (part.name.starts_with(knock.pegs))
        gap = std::max(gap, d);
      else
        clearance = std::min(clearance, d);
    }
  }
  const bool fits = gap <= widest_gap && clearance >= least_clearance;
  std::printf("%s: at most %.3f mm to its pegs, at least %.2f mm to all else%s\n", knock.name.c_str(),
              gap / mm, clearance / mm, fits ? "" : ": NOT AS IT SHOULD BE");
  return fits;
}

bool check() {
  const std::array scene = make_scene();
  const Model bar = make_bar();
  bool good = check_solids(bar);
  for (const Model& model : scene) good &= check_solids(model);
  std::vector<Eigen::Vector3d> points;
  for (const Part& part : bar.parts)
    points.insert(points.end(), part.solid.points.begin(), part.solid.points.end());
  for (const Knock& knock : make_knocks()) good &= check_knock(knock, scene, points);
  // The way, if every knock ended short of its pegs by as much as has to be clear; that is what is nearest
  // then.
  const double least =
      clearance_on_way(make_route(make_knocks(), -least_clearance), tree_of(scene), points, points, stride);
  const bool free = least >= 0.9 * least_clearance;
  std::printf("clearance of the bar on its way: %.2f mm%s\n", least / mm, free ? "" : ": TOO LITTLE");
  return good && free;
}

}  // namespace
}  // namespace fulcrum::content

int main(int argc, char** argv) {
  using namespace fulcrum::content;
  const auto models = [] {
    const auto scene = make_scene();
    std::vector<Model> all(scene.begin(), scene.end());
    all.push_back(make_bench());
    all.push_back(make_bar());
    return all;
  };
  const auto route = [] {
    return route_yaml("each peg once, the last five at once, and back before the next", "make_knock",
                      make_route(make_knocks(), press_depth));
  };
  const auto checkpoints = [] { return knocks_yaml(make_knocks()); };
  return run_maker({"make_knock", models, route, checkpoints, check}, argc, argv);
}
