#pragma once

#include <span>
#include <vector>

#include "tools/content/mesh/solid.h"

namespace fulcrum::content {

// One place on a centreline; `swell` is added to the tube's radius there.
struct Station {
  Eigen::Vector3d p;        // m
  Eigen::Vector3d tangent;  // unit
  double swell = 0.0;       // m
};

struct Centreline {
  std::vector<Eigen::Vector3d> corners;  // (n x 3) m, where the straight runs would meet
  double bend_radius = 0.0;              // m
  double bend_step = 9.0 * degree;       // rad, between stations
  double weld_bead = 0.0;                // m, height of the bead where a bend is welded to a run; 0: none
};

// The centreline with its bends rounded.
std::vector<Station> stations(const Centreline& line);

enum class TubeEnd {
  flat,  // buried in a flange or a nut
  cut,   // seen: a shallow recess shows the bore
  stud,  // seen: the chamfered end of a rod
};

// A solid round bar along the stations.
Solid tube(std::span<const Station> line, double radius, int columns, TubeEnd start, TubeEnd end);

}  // namespace fulcrum::content
