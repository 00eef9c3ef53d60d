#pragma once
// The surface of a body that is given by a formula, as a closed mesh.

#include <functional>
#include <vector>

#include "tools/content/mesh/solid.h"

namespace fulcrum::content {

// Negative inside, positive outside, about as large as the distance to the surface.
using Implicit = std::function<double(const Eigen::Vector3d&)>;

// Planes of a grid: ascending coordinates along each axis. They may lie closer where there is more to see.
struct GridLines {
  std::vector<double> x, y, z;
};

// From first to last, in steps that the function asks for at each place; they are stretched to fit.
std::vector<double> grid_line(double first, double last, const std::function<double(double)>& step);

// One point for each cell that the surface passes, pulled onto the surface but kept in its cell. The body has
// to lie within the grid, and no two parts of its surface within one cell. In the units of the grid.
Solid surface_nets(const Implicit& body, const GridLines& lines);

// Central differences over 2 * reach.
Eigen::Vector3d gradient(const Implicit& body, const Eigen::Vector3d& p, double reach);

}  // namespace fulcrum::content
