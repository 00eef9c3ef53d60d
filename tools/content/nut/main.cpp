// make_nut: writes the models of the nut's scene, prints the ways of its hands, and checks both.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <span>
#include <string>

#include "haptics/math/functions.h"
#include "tools/content/mesh/maker.h"
#include "tools/content/mesh/solid_check.h"
#include "tools/content/mesh/way_check.h"
#include "tools/content/nut/nut_part.h"
#include "tools/content/nut/place.h"
#include "tools/content/nut/plant.h"
#include "tools/content/nut/route.h"

namespace fulcrum::content {
namespace {

constexpr double stride = 0.5 * mm;
constexpr double least_clearance = 4.0 * mm;   // on the way to the bolt
constexpr double least_in_thread = 0.02 * mm;  // on the way down it
constexpr double widest_off_step = 0.001 * mm;

std::vector<Eigen::Vector3d> nut_points() {
  return make_nut().parts.front().solid.points;
}

// On its way to the bolt's end the nut is clear of everything, and on its way down the thread, too.
bool check_way() {
  const std::array scene{make_cover(), make_wall()};
  const TriangleTree tree = tree_of(scene);
  const std::vector<RoutePose> route = make_route(0.0);
  const auto at_end = std::find_if(route.begin(), route.end(),
                                   [](const RoutePose& pose) { return pose.note == "at the bolt's end"; });
  const std::vector<RoutePose> to_bolt(route.begin(), at_end), down(at_end + 1, route.end() - 1);
  const double open = clearance_on_way(to_bolt, tree, nut_points(), {}, stride);
  std::printf("clearance of the nut on its way to the bolt: %.2f mm%s\n", open / mm,
              open >= least_clearance ? "" : ": TOO LITTLE");
  double in_thread = 5.0 * mm, off = 0.0, angle = 0.0;
  for (const RoutePose& pose : down) {
    for (const Eigen::Vector3d& p : nut_points()) in_thread = tree.distance(pose.X_WT * p, in_thread);
    const Eigen::Vector3d x = pose.X_WT.linear().col(0);
    angle = math::atan2(x.y(), x.x());
    off = std::max(off, std::abs(out_of_step(pose.X_WT.translation().z(), angle)));
  }
  std::printf("on its way down the thread: %.3f mm, out of step by at most %.6f mm%s\n", in_thread / mm,
              off / mm,
              in_thread >= least_in_thread && off <= widest_off_step ? "" : ": NOT AS IT SHOULD BE");
  return open >= least_clearance && in_thread >= least_in_thread && off <= widest_off_step;
}

bool check() {
  bool good = true;
  for (const Model& model : {make_cover(), make_wall(), make_nut()}) good &= check_solids(model);
  return good & check_way();
}

std::string tilted_yaml() {
  return waypoints_yaml(
      "The expert's way, but the nut is tilted once it is on the thread: torque that no force tells of.",
      "make_nut --tilted", make_tilted_route(light_press));
}

}  // namespace
}  // namespace fulcrum::content

int main(int argc, char** argv) {
  using namespace fulcrum::content;
  if (argc == 2 && std::string(argv[1]) == "--tilted") {
    std::cout << tilted_yaml();
    return 0;
  }
  const auto models = [] { return std::vector{make_cover(), make_wall(), make_nut()}; };
  const auto route = [] {
    return route_yaml(
        "the nut behind the pipe, set on straight, and run down a stroke of the fingers at a time",
        "make_nut", make_route(light_press));
  };
  return run_maker({"make_nut", models, route, places_yaml, check}, argc, argv);
}
