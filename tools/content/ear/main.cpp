// make_ear: writes the models of the ear scene, prints the route through it, and checks both.

#include <array>

#include "tools/content/ear/ear.h"
#include "tools/content/ear/ear_check.h"
#include "tools/content/ear/needle.h"
#include "tools/content/mesh/maker.h"
#include "tools/content/mesh/solid_check.h"
#include "tools/content/mesh/way_check.h"

namespace fulcrum::content {
namespace {

bool check() {
  const Flesh flesh;
  const std::array ear{make_ear(flesh)};
  const Model needle = make_needle();
  const Passage passage(flesh);
  bool good = check_solids(ear.front());
  good &= check_solids(make_open_ear(flesh));
  good &= check_solids(needle);
  good &= check_canal(flesh.canal());
  good &= check_rolls(passage);
  good &= check_way(make_route(passage), tree_of(ear), needle);
  return good;
}

}  // namespace
}  // namespace fulcrum::content

int main(int argc, char** argv) {
  using namespace fulcrum::content;
  const auto models = [] {
    const Flesh flesh;
    return std::vector{make_ear(flesh), make_open_ear(flesh), make_needle()};
  };
  const auto route = [] {
    return route_yaml("along the middle, and rolled between the bends", "make_ear",
                      make_route(Passage{Flesh()}));
  };
  const auto checkpoints = [] { return stops_yaml(Passage{Flesh()}); };
  return run_maker({"make_ear", models, route, checkpoints, check}, argc, argv);
}
