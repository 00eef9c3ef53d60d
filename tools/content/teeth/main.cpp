// make_teeth: writes the models of the teeth scene, prints the route through it, and checks both.

#include <cstdio>
#include <filesystem>
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

int write_models(const std::string& folder) {
  std::error_code failure;
  std::filesystem::create_directories(folder, failure);
  for (const Model& model : {make_jaw(make_dentition()), make_explorer()}) {
    const std::string trouble = write_glb(model, folder + "/" + model.name + ".glb", "make_teeth");
    if (!trouble.empty()) {
      std::cerr << trouble << "\n";
      return 1;
    }
    std::printf("%s: {parts: %zu, triangles: %zu}\n", model.name.c_str(), model.parts.size(),
                triangle_count(model));
  }
  return 0;
}

bool check_solids(const Model& model) {
  bool sound = true;
  for (const Part& part : model.parts) {
    const std::string trouble = what_is_wrong(part.solid);
    std::printf("%s: %zu triangles%s%s\n", part.name.c_str(), part.solid.triangles.size(),
                trouble.empty() ? "" : ": ", trouble.c_str());
    sound &= trouble.empty();
  }
  return sound;
}

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
  std::cout << (stops_alone ? stops_yaml(stops) : route_yaml(make_route(stops)));
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
  return write_models(what);
}

}  // namespace
}  // namespace fulcrum::content

int main(int argc, char** argv) {
  return fulcrum::content::run(std::span(argv, static_cast<std::size_t>(argc)));
}
