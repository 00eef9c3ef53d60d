#pragma once
// Steel as tools leave it, and as use does: pictures for its surfaces, and wear at its edges.

#include "tools/content/mesh/model.h"

namespace fulcrum::content {

// A material of that colour and roughness in the mean, brushed along u, or turned where that goes round: fine
// lines, some of them duller, and where hands have been. Its pictures are square.
Material brushed(const std::string& name, const std::array<double, 3>& base_colour, double roughness);

// Painted steel, a picture twice as high as wide: mottled paint of that colour and a little grime, which has
// come off in chips down to the steel, most of them about v = worn_at.
inline constexpr double worn_at = 0.5;
Material painted(const std::string& name, const Eigen::Vector3d& paint);

// Where it is rubbed it is bright, in hollows dark: colours of a solid's points, times its material's.
Coat worn(const Solid& solid);

}  // namespace fulcrum::content
