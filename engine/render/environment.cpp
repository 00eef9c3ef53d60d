#include "engine/render/environment.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <glm/gtc/packing.hpp>
#include <numbers>

#include "engine/render/octahedral_map.h"

namespace fulcrum::render {
namespace {

constexpr float kFullTurn = 2.0F * std::numbers::pi_v<float>;
constexpr float kInner = 0.75F;  // of a level's side: the rest is its border (octahedral_map.h)
constexpr float kMirror =
    0.08F;  // up to this roughness, a pixel of the sharpest level is wider than the lobe
constexpr float kBrightest = 60000.0F;  // that a half float holds

template <typename Value>
OctahedralMap map_of(std::uint32_t side, const Value& value) {
  OctahedralMap made{side, {}};
  made.pixels.reserve(std::size_t{side} * side);
  for (std::uint32_t row = 0; row < side; ++row)
    for (std::uint32_t column = 0; column < side; ++column)
      made.pixels.push_back(value(made.direction(column, row)));
  return made;
}

// The same, coarser and coarser: what a sample that stands for a wide cone looks up.
std::vector<OctahedralMap> coarser_and_coarser(const OctahedralMap& sharpest) {
  std::vector<OctahedralMap> made{sharpest};
  while (made.back().side > 8) {
    const OctahedralMap& fine = made.back();
    OctahedralMap coarse{fine.side / 2, {}};
    for (std::uint32_t row = 0; row < coarse.side; ++row)
      for (std::uint32_t column = 0; column < coarse.side; ++column) {
        const glm::vec3* first = fine.pixels.data() + std::size_t{2} * row * fine.side + 2 * column;
        coarse.pixels.push_back(0.25F * (first[0] + first[1] + first[fine.side] + first[fine.side + 1]));
      }
    made.push_back(std::move(coarse));
  }
  return made;
}

// A direction about +z that a mirror of this roughness takes light from, seen along +z, and the level of
// coarser_and_coarser() that is as wide as what the sample stands for.
struct Sample {
  glm::vec3 direction;
  float weight;
  std::size_t level;
};

std::vector<Sample> lobe(float roughness, std::uint32_t count) {
  const float alpha2 = std::pow(roughness, 4.0F);
  const float pixels = std::pow(kInner * static_cast<float>(kEnvironmentSize), 2.0F);  // of the whole sphere
  std::vector<Sample> made;
  for (std::uint32_t i = 0; i < count; ++i) {
    // Half vectors as the GGX distribution has them, at the points of a spiral.
    const float share = (static_cast<float>(i) + 0.5F) / static_cast<float>(count);
    const float turn = kFullTurn * std::fmod(static_cast<float>(i) * 0.618034F, 1.0F);
    const float cosine2 = (1.0F - share) / (1.0F + (alpha2 - 1.0F) * share);
    const float cosine = std::sqrt(cosine2), sine = std::sqrt(1.0F - cosine2);
    const glm::vec3 half(sine * std::cos(turn), sine * std::sin(turn), cosine);
    const glm::vec3 direction = 2.0F * cosine * half - glm::vec3(0, 0, 1);
    if (direction.z <= 0.0F) continue;
    // The density of directions is alpha2 / (4 pi bottom^2) per steradian: as wide as this is what one stands
    // for.
    const float bottom = cosine2 * (alpha2 - 1.0F) + 1.0F;
    const float wide = pixels * bottom * bottom / (alpha2 * static_cast<float>(count));  // pixels
    const float level = std::max(0.0F, 0.5F * std::log2(wide) + 1.0F);
    made.push_back({direction, direction.z, static_cast<std::size_t>(std::lround(level))});
  }
  return made;
}

glm::vec3 blurred(const std::vector<OctahedralMap>& sources, const std::vector<Sample>& samples,
                  const glm::vec3& d) {
  const glm::vec3 aside = std::abs(d.y) < 0.9F ? glm::vec3(0, 1, 0) : glm::vec3(1, 0, 0);
  const glm::vec3 x = glm::normalize(glm::cross(aside, d)), y = glm::cross(d, x);
  glm::vec3 sum(0.0F);
  float weights = 0.0F;
  for (const Sample& sample : samples) {
    const glm::vec3 from = sample.direction.x * x + sample.direction.y * y + sample.direction.z * d;
    sum += sample.weight * sources[std::min(sample.level, sources.size() - 1)].at(from);
    weights += sample.weight;
  }
  return sum / weights;
}

std::vector<std::uint8_t> as_halves(const OctahedralMap& level) {
  std::vector<std::uint8_t> bytes(level.pixels.size() * sizeof(std::uint64_t));
  for (std::size_t i = 0; i < level.pixels.size(); ++i) {
    const glm::vec3 fits = glm::min(level.pixels[i], glm::vec3(kBrightest));
    const std::uint64_t packed = glm::packHalf4x16(glm::vec4(fits, 1.0F));
    std::memcpy(bytes.data() + i * sizeof(packed), &packed, sizeof(packed));
  }
  return bytes;
}

// Directions spread evenly: rings of equal height, each with a turn of its own.
constexpr std::uint32_t kRings = 64, kOnRing = 64;

std::vector<Beam> beams_in_rings(const Surroundings& around) {
  std::vector<Beam> beams;
  for (std::uint32_t ring = 0; ring < kRings; ++ring) {
    const float y = 1.0F - 2.0F * (static_cast<float>(ring) + 0.5F) / static_cast<float>(kRings);
    const float across = std::sqrt(1.0F - y * y);
    for (std::uint32_t i = 0; i < kOnRing; ++i) {
      const float turn = kFullTurn * (static_cast<float>(i) + 0.5F * static_cast<float>(ring % 2)) / kOnRing;
      const glm::vec3 d(across * std::cos(turn), y, across * std::sin(turn));
      beams.push_back({d, around.radiance(d), 1.0F / static_cast<float>(kRings * kOnRing)});
    }
  }
  return beams;
}

// The nine real harmonics, each with pi / (2 l + 1) of its own sum as the cosine leaves of it, over pi.
Irradiance irradiance_of(const std::vector<Beam>& beams) {
  std::array<glm::vec3, 9> sums{};
  for (const auto& [d, light, share] : beams) {
    const std::array<float, 9> basis{
        1.0F, d.x, d.y, d.z, d.x * d.y, d.y * d.z, d.z * d.x, 3.0F * d.z * d.z - 1.0F, d.x * d.x - d.y * d.y};
    for (std::size_t k = 0; k < basis.size(); ++k) sums[k] += light * (basis[k] * share);
  }
  // Of l = 0, 1, 2 the cosine leaves pi, 2 pi / 3 and pi / 4; the harmonics' own squares are 1 / (4 pi),
  // 3 / (4 pi), 15 / (4 pi) (of 3 z^2 - 1: 5 / (16 pi); of x^2 - y^2: 15 / (16 pi)); all directions are
  // 4 pi, and the whole is over pi.
  constexpr float first = 2.0F, second = 3.75F, zonal = 0.3125F, last = 0.9375F;
  Irradiance made;
  for (int i = 0; i < 3; ++i) {
    const auto c = static_cast<std::size_t>(i);
    made.linear[c] = {first * sums[1][i], first * sums[2][i], first * sums[3][i],
                      sums[0][i] - zonal * sums[7][i]};
    made.quadratic[c] = {second * sums[4][i], second * sums[5][i], 3.0F * zonal * sums[7][i],
                         second * sums[6][i]};
  }
  made.rest = last * sums[8];
  return made;
}

}  // namespace

glm::vec3 irradiance(const Irradiance& around, const glm::vec3& n) {
  glm::vec3 sum = around.rest * (n.x * n.x - n.y * n.y);
  for (int i = 0; i < 3; ++i) {
    const auto c = static_cast<std::size_t>(i);
    sum[i] += glm::dot(around.linear[c], glm::vec4(n, 1.0F)) +
              glm::dot(around.quadratic[c], glm::vec4(n.x * n.y, n.y * n.z, n.z * n.z, n.z * n.x));
  }
  return glm::max(sum, glm::vec3(0.0F));
}

float environment_roughness(std::uint32_t level) {
  return kMirror + (1.0F - kMirror) * static_cast<float>(level) / static_cast<float>(kEnvironmentLevels - 1);
}

std::uint64_t environment_bytes() {
  std::uint64_t texels = 0;
  for (std::uint32_t level = 0; level < kEnvironmentLevels; ++level) {
    const std::uint64_t side = kEnvironmentSize >> level;
    texels += side * side;
  }
  return texels * sizeof(std::uint64_t);
}

Environment make_environment(const Surroundings& around, std::optional<std::uint32_t> samples) {
  Environment made;
  made.irradiance = irradiance_of(around.beams.empty() ? beams_in_rings(around) : around.beams);
  const std::vector<OctahedralMap> sources = coarser_and_coarser(map_of(kEnvironmentSize, around.radiance));
  made.levels.push_back(as_halves(sources.front()));
  const std::uint32_t first = samples.value_or(around.beams.empty() ? kLobeSamples : kLobeSamplesOfPicture);
  for (std::uint32_t level = 1; level < kEnvironmentLevels; ++level) {
    const std::vector<Sample> each = lobe(environment_roughness(level), first << (2 * (level - 1)));
    made.levels.push_back(as_halves(
        map_of(kEnvironmentSize >> level, [&](const glm::vec3& d) { return blurred(sources, each, d); })));
  }
  return made;
}

}  // namespace fulcrum::render
