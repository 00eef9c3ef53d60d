#pragma once
// Light from all around, made ready for shaders: what a matt surface receives for each way that it may face,
// and what a rougher and rougher mirror shows in each direction.
//
// Irradiance by spherical harmonics: R. Ramamoorthi and P. Hanrahan, "An Efficient Representation for
// Irradiance Environment Maps", SIGGRAPH 2001; packed for shaders as in P.-P. Sloan, "Stupid Spherical
// Harmonics Tricks", 2008. Mirrors that grow rough: B. Karis, "Real Shading in Unreal Engine 4", 2013 (split
// sum). Octahedral map: Z. Cigolle et al., "A Survey of Efficient Representations for Independent Unit
// Vectors", JCGT 2014.

#include <array>
#include <cstdint>
#include <functional>
#include <glm/glm.hpp>
#include <vector>

namespace fulcrum::render {

// Radiance that arrives from a unit direction in the world; linear.
using Surroundings = std::function<glm::vec3(const glm::vec3& from)>;

// Of an octahedral map, +y in its middle: pixels a side of its sharpest level, of a mirror; and levels, each
// half as large as the one before and of a roughness that grows evenly to 1.
constexpr std::uint32_t kEnvironmentSize = 256;
constexpr std::uint32_t kEnvironmentLevels = 6;

// Irradiance / pi for a unit normal n: for each colour dot(linear[i], (n, 1)) + dot(quadratic[i], n.xyzz *
// n.yzzx), and rest * (n.x^2 - n.y^2) on top.
struct Irradiance {
  std::array<glm::vec4, 3> linear{};
  std::array<glm::vec4, 3> quadratic{};
  glm::vec3 rest{0.0F};
};

// Facing n, unit; never less than nothing.
glm::vec3 irradiance(const Irradiance& around, const glm::vec3& n);

struct Environment {
  Irradiance irradiance;
  // RGBA, half floats, row by row. Along each side of a level an eighth of its pixels repeats what lies
  // beyond the fold, so that a filter never meets an edge.
  std::vector<std::vector<std::uint8_t>> levels;
};

Environment make_environment(const Surroundings& radiance);

// The roughness that a level is made for.
float environment_roughness(std::uint32_t level);

// Bytes of the map, all levels.
std::uint64_t environment_bytes();

}  // namespace fulcrum::render
