// make_ear: writes the models of the ear scene, prints the route through it, and checks both.

#include <iostream>
#include <span>
#include <string>

#include "tools/content/ear/ear.h"
#include "tools/content/ear/ear_check.h"
#include "tools/content/ear/needle.h"
#include "tools/content/mesh/glb_writer.h"
#include "tools/content/mesh/solid_check.h"

namespace fulcrum::content {
namespace {

TriangleTree tree_of(const Model& model) {
  TriangleTree tree;
  for (const Part& part : model.parts) tree.add(part.solid);
  tree.build();
  return tree;
}

int check() {
  const Flesh flesh;
  const Model ear = make_ear(flesh);
  const Model needle = make_needle();
  const Passage passage(flesh);
  bool good = check_solids(ear);
  good &= check_solids(make_open_ear(flesh));
  good &= check_solids(needle);
  good &= check_canal(flesh.canal());
  good &= check_rolls(passage);
  good &= check_way(make_route(passage), tree_of(ear), needle);
  return good ? 0 : 1;
}

int run(std::span<char*> arguments) {
  const std::string what = arguments.size() == 2 ? arguments[1] : "";
  if (what == "--check") return check();
  if (what == "--route" || what == "--checkpoints") {
    const Passage passage{Flesh()};
    std::cout << (what == "--checkpoints" ? stops_yaml(passage)
                                          : route_yaml("along the middle, and rolled between the bends",
                                                       "make_ear", make_route(passage)));
    return 0;
  }
  if (what.empty() || what.starts_with("-")) {
    std::cerr << "usage: make_ear OUTDIR | --route | --checkpoints | --check\n";
    return 2;
  }
  const Flesh flesh;
  return write_models({make_ear(flesh), make_open_ear(flesh), make_needle()}, what, "make_ear") ? 0 : 1;
}

}  // namespace
}  // namespace fulcrum::content

int main(int argc, char** argv) {
  return fulcrum::content::run(std::span(argv, static_cast<std::size_t>(argc)));
}
