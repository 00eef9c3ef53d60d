// make_teeth: writes the models of the teeth scene, prints the route through it, and checks both.

#include <iostream>
#include <span>
#include <string>

#include "tools/content/mesh/glb_writer.h"
#include "tools/content/mesh/solid_check.h"
#include "tools/content/teeth/explorer.h"
#include "tools/content/teeth/jaw.h"
#include "tools/content/teeth/jaw_check.h"
#include "tools/content/teeth/route.h"

namespace fulcrum::content {
namespace {

TriangleTree tree_of(const Model& model) {
  TriangleTree tree;
  for (const Part& part : model.parts) tree.add(part.solid);
  tree.build();
  return tree;
}

int check() {
  const Dentition dentition = make_dentition();
  const Model jaw = make_jaw(dentition);
  const Model explorer = make_explorer();
  const TriangleTree scene = tree_of(jaw);
  bool good = check_solids(jaw);
  good &= check_solids(explorer);
  good &= check_sizes(dentition, jaw);
  good &= check_contacts(dentition);
  good &= check_way(make_route(make_stops(dentition, scene)), scene, explorer);
  return good ? 0 : 1;
}

// The expert's way, or the checkpoints on it.
void print_route(bool stops_alone) {
  const Dentition dentition = make_dentition();
  const std::vector<Stop> stops = make_stops(dentition, tree_of(make_jaw(dentition)));
  std::cout << (stops_alone
                    ? stops_yaml(stops)
                    : route_yaml("over each place, down to it, a light touch that lasts, and up again",
                                 "make_teeth", make_route(stops)));
}

int run(std::span<char*> arguments) {
  const std::string what = arguments.size() == 2 ? arguments[1] : "";
  if (what == "--check") return check();
  if (what == "--route" || what == "--checkpoints") {
    print_route(what == "--checkpoints");
    return 0;
  }
  if (what.empty() || what.starts_with("-")) {
    std::cerr << "usage: make_teeth OUTDIR | --route | --checkpoints | --check\n";
    return 2;
  }
  return write_models({make_jaw(make_dentition()), make_explorer()}, what, "make_teeth") ? 0 : 1;
}

}  // namespace
}  // namespace fulcrum::content

int main(int argc, char** argv) {
  return fulcrum::content::run(std::span(argv, static_cast<std::size_t>(argc)));
}
