#pragma once
// Light from all around, made ready for shaders: what a matt surface receives for each way that it may face,
// and what a rougher and rougher mirror shows in each direction.
//
// Irradiance by spherical harmonics: R. Ramamoorthi and P. Hanrahan, "An Efficient Representation for
// Irradiance Environment Maps", SIGGRAPH 2001; packed for shaders as in P.-P. Sloan, "Stupid Spherical
// Harmonics Tricks", 2008. Mirrors that grow rough: B. Karis, "Real Shading in Unreal Engine 4", 2013 (split
// sum), each sample from a level as coarse as what it stands for: M. Colbert and J. Krivanek, "GPU-Based
// Importance Sampling", GPU Gems 3, 2007.

#include <array>
#include <cstdint>
#include <glm/glm.hpp>
#include <optional>
#include <vector>

#include "engine/render/surroundings.h"

namespace fulcrum::render {

// Of the map (octahedral_map.h): pixels a side of its sharpest level, of a mirror; and levels, each
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
  // RGBA, half floats, row by row.
  std::vector<std::vector<std::uint8_t>> levels;
};

// Samples of a lobe, for each pixel of the first rough level; of each level after it, four times as many. Of
// light that changes little, and of a picture, in which there may be a sun.
constexpr std::uint32_t kLobeSamples = 32, kLobeSamplesOfPicture = 128;

// samples: of the first rough level; none: what its light needs.
Environment make_environment(const Surroundings& around, std::optional<std::uint32_t> samples = {});

// The roughness that a level is made for.
float environment_roughness(std::uint32_t level);

// Bytes of the map, all levels.
std::uint64_t environment_bytes();

}  // namespace fulcrum::render
