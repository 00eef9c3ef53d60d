// make_knock: writes the models of the knock scene, prints the knocks in it, and checks both.

#include <array>
#include <cstdio>

#include "tools/content/knock/bar.h"
#include "tools/content/knock/pegs.h"
#include "tools/content/knock/route.h"
#include "tools/content/mesh/maker.h"
#include "tools/content/mesh/solid_check.h"
#include "tools/content/mesh/way_check.h"
#include "tools/content/mesh/worktop.h"

namespace fulcrum::content {
namespace {

constexpr double press = 3.0 * mm;
constexpr double stride = 1.0 * mm;

std::array<Model, 4> make_scene() {
  return {make_boards(), make_steel_pegs(), make_wooden_pegs(), make_rubber_pegs()};
}

bool check() {
  const std::array scene = make_scene();
  bool good = check_solids(make_bar());
  for (const Model& model : scene) good &= check_solids(model);
  return good;
}

}  // namespace
}  // namespace fulcrum::content

int main(int argc, char** argv) {
  using namespace fulcrum::content;
  const auto models = [] {
    const auto scene = make_scene();
    std::vector<Model> all(scene.begin(), scene.end());
    all.push_back(make_worktop({0.0, bench_height, -0.15}));
    all.push_back(make_bar());
    return all;
  };
  const auto route = [] {
    return route_yaml("each peg once, the last five at once, and back before the next", "make_knock",
                      make_route(make_knocks(), press));
  };
  const auto checkpoints = [] { return knocks_yaml(make_knocks()); };
  return run_maker({"make_knock", models, route, checkpoints, check}, argc, argv);
}
