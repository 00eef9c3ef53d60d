#pragma once

#include <array>
#include <string>
#include <vector>

#include "tools/content/mesh/solid.h"

namespace fulcrum::content {

// Metallic-roughness, as glTF has it.
struct Material {
  std::string name;
  std::array<double, 3> base_colour;  // linear
  double metallic = 0.0;
  double roughness = 0.5;
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
};

struct Model {
  std::string name;
  std::vector<Material> materials;
  std::vector<Part> parts;
};

std::size_t triangle_count(const Model& model);

}  // namespace fulcrum::content
