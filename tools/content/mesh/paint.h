#pragma once
// Colours of the points of a body that is given by a formula, with the light that its hollows keep out.

#include <vector>

#include "tools/content/mesh/surface_nets.h"

namespace fulcrum::content {

// a at 0, b at 1.
Eigen::Vector3d mixed(const Eigen::Vector3d& a, const Eigen::Vector3d& b, double t);

// Smooth noise of about unit size, without any table.
double mottle(const Eigen::Vector3d& p);

// How much of the sky (0 to 1) a point sees that has the normal n, looking as far as `reaches` of the grid's
// units.
double openness(const Implicit& scene, const Eigen::Vector3d& p, const Eigen::Vector3d& n,
                const std::vector<double>& reaches);

// Light that gets into a hollow has been on its walls before: what is shut in gains their colour.
Eigen::Vector3d shut_in(const Eigen::Vector3d& colour, double open, const Eigen::Vector3d& walls);

}  // namespace fulcrum::content
