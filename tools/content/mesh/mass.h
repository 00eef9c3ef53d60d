#pragma once

#include "tools/content/mesh/solid.h"

namespace fulcrum::content {

inline constexpr double steel_density = 7850.0;  // kg/m^3

struct MassProperties {
  double mass = 0.0;        // kg
  Eigen::Vector3d centre;   // (3) m
  Eigen::Matrix3d inertia;  // (3 x 3) kg m^2, about the centre
};

// Of a closed solid of uniform density (kg/m^3).
MassProperties mass_properties(const Solid& solid, double density);

}  // namespace fulcrum::content
