#pragma once

#include "tools/content/piping/plant.h"

namespace fulcrum::content {

// A bar of channel steel: from z = 0 to its length, the outside of its web at y = 0, its flanges towards -y.
struct Channel {
  double width;      // m
  double depth;      // m
  double thickness;  // m
};

Solid channel_bar(const Channel& channel, double length);

// A pipe held on the face of a bar by a U-bolt over a saddle.
struct Clamp {
  std::string name;          // "03/1"
  Eigen::Vector3d p;         // m, on the pipe's axis
  Eigen::Vector3d axis;      // unit, of the pipe
  Eigen::Vector3d from_bar;  // unit, from the bar to the pipe
  double pipe_radius;        // m
  double distance;           // m, from the bar's face to the pipe's axis
  double web;                // m, thickness of what the U-bolt goes through
};

void add_clamp(Plant* plant, const Clamp& clamp);

}  // namespace fulcrum::content
