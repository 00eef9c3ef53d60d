#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include "tools/content/mesh/raster.h"
#include "tools/content/mesh/solid.h"
#include "tools/content/mesh/unwrap.h"

namespace fulcrum::content {

// What varies over a surface more finely than its points lie, as glTF has it. Their values are times the
// material's.
struct Pictures {
  std::optional<Raster> base_colour{};  // sRGB encoded
  std::optional<Raster> metal_rough{};  // roughness in green, metallic in blue
  std::optional<Raster> normal{};       // unit, 127.5 (1 + n): x along u, y against v, z off the surface
};

// Metallic-roughness, as glTF has it.
struct Material {
  std::string name;
  std::array<double, 3> base_colour;  // linear
  double metallic = 0.0;
  double roughness = 0.5;
  std::optional<Pictures> pictures{};  // on parts that say where they lie on them
};

// Pictures as a projector throws them: point p is at (u, v) = ((p - origin) . along_u, (p - origin) .
// along_v) of them, (0, 0) at their top left, and beyond 0 and 1 they repeat. Thrown onto what faces the
// projector: what looks along along_v x along_u.
struct Projection {
  Eigen::Vector3d origin, along_u, along_v;  // m, 1/m, 1/m
};

// Wider than the 30 degrees between the sides of a twelve-sided stud, narrower than a 45 degree chamfer.
inline constexpr double default_crease = 38.0 * degree;

// What is known at each point of a solid, where there is more to know than its shape.
struct Coat {
  std::vector<Eigen::Vector3d> normals;  // (n x 3) unit, of a surface that is known as a formula; or none
  std::vector<Eigen::Vector3d> colours;  // (n x 3) linear, times the material's
};

struct Part {
  std::string name;  // "bolt/07/a/3": kind, line, place
  std::size_t material = 0;
  Solid solid;
  double crease = default_crease;  // rad: sharper edges are drawn sharp, where no normals are known
  Coat coat{};
  std::vector<Projection> projections{};  // of its material's pictures: that which a point faces the most
  CornerUv uv{};                          // in its material's pictures, where nothing is projected; or none
};

struct Model {
  std::string name;
  std::vector<Material> materials;
  std::vector<Part> parts;
};

std::size_t triangle_count(const Model& model);

}  // namespace fulcrum::content
