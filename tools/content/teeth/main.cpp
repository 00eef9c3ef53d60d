// make_teeth: writes the models of the teeth scene, prints the route through it, and checks both.

#include <array>

#include "tools/content/mesh/maker.h"
#include "tools/content/mesh/solid_check.h"
#include "tools/content/mesh/way_check.h"
#include "tools/content/teeth/explorer.h"
#include "tools/content/teeth/jaw.h"
#include "tools/content/teeth/jaw_check.h"
#include "tools/content/teeth/route.h"

namespace fulcrum::content {
namespace {

bool check() {
  const Dentition dentition = make_dentition();
  const std::array jaw{make_jaw(dentition)};
  const Model explorer = make_explorer();
  const TriangleTree scene = tree_of(jaw);
  bool good = check_solids(jaw.front());
  good &= check_solids(explorer);
  good &= check_sizes(dentition, jaw.front());
  good &= check_contacts(dentition);
  good &= check_way(make_route(make_stops(dentition, scene)), scene, explorer);
  return good;
}

std::vector<Stop> stops() {
  const Dentition dentition = make_dentition();
  return make_stops(dentition, tree_of(std::array{make_jaw(dentition)}));
}

}  // namespace
}  // namespace fulcrum::content

int main(int argc, char** argv) {
  using namespace fulcrum::content;
  const auto models = [] { return std::vector{make_jaw(make_dentition()), make_explorer()}; };
  const auto route = [] {
    return route_yaml("over each place, down to it, a light touch that lasts, and up again", "make_teeth",
                      make_route(stops()));
  };
  const auto checkpoints = [] { return stops_yaml(stops()); };
  return run_maker({"make_teeth", models, route, checkpoints, check}, argc, argv);
}
